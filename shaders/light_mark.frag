// Marks pixels in the stencil buffer alone.
void main() {}
