// The share of the far plane's distance: 0 is the eye.
float shown_depth(float depth, float near, float far) { return near / (far - depth * (far - near)); }
