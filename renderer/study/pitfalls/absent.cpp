// What the catalogue leaves out, and why; the tests that hold it are named.
#include "renderer/study/pitfalls/catalogue.h"

namespace gbl {
namespace {

// clang-format off
constexpr AbsentPitfall kAbsent[] = {
    {"unsized-rgba-is-8bit", "a matter of the format's name: the lab has sized formats only. Test Portability.UnsizedRgbaIs8Bit"},
    {"subviewport-uv", "each face of a cube is drawn into a G-buffer of its own size. Test ReflectionsGl.APlanesPictureIsTheMirroredCamerasFrame"},
    {"fragcoord-viewport-origin", "the lab draws each picture into a texture of its own, so no viewport has an origin"},
    {"gbuffer-filter-linear", "not yet: it needs a G-buffer of another size than the picture; the lab reads texels by their address"},
    {"radius-nan-dim-light", "a light too dim for the threshold has range 0. Test RangeAtThreshold.OfALightThatIsTooDimIsNothing"},
    {"frame1-differs", "every pass sets all of its state, so no frame depends on the one before"},
    {"nan-sticks", "sums of light are cleared in each frame; nonfinite_pixels counts what is no number"},
    {"pow-negative-base", "undefined in GLSL, so it shows another failure on each driver; the lab never takes a power of a negative number"},
    {"pow-zero-zero", "undefined in GLSL; the lab says 1, as C does"},
    {"light-on-surface", "it needs a pixel's centre at the light to the last bit; the lab divides by no less than 1e-6"},
    {"normalize-zero-normal", "a cosine that is no number counts as turned away in the lab, so the background stays unlit"},
    {"depth-blit-mismatch", "an error of GL and not of a picture; the lab copies depth between equal formats only. Test Portability.DepthBlitMismatch"},
    {"depthmask-false-clear", "the lab sets masks before it clears. Test Portability.DepthmaskFalseClear"},
    {"id-pick-y-flip", "objects are picked in pixels from the top left and flipped in one place"},
    {"readpixels-stall", "costs time and no accuracy; the lab reads back some frames late"},
    {"quads-in-core", "an error of GL; the lab draws triangles. Test Portability.QuadsInCore"},
    {"light-moved-in-draw", "lights are functions of time. Test LightMovedInDraw.DrawingTwiceMovesNothing"},
    {"light-drift", "lights are functions of time. Turned in place in float they are 1.9 units off after an hour at 60 Hz, and 39 at 144 Hz. Test LightDrift"},
    {"rand-colours", "random numbers are the lab's own, equal on every machine. Test Lights.HashOf4096IsAConstantOnEveryMachine"},
    {"gl-enable-two-args", "does not compile"},
    {"rgb8-attachment", "the lab has no attachment of three channels"},
    {"ubo-64000", "lights lie in a texture. Test Portability.Ubo64000"},
    {"colour-not-cleared", "it needs the frame before; in the lab equal settings give equal pictures"},
    {"count-overflow", "an error of C++, not of a renderer"},
    {"lightnum-one-nan", "one light stands in the middle. Test Lights.OneStandsOnTheAxisAndTwoInOneRow"},
};
// clang-format on

}  // namespace

std::vector<AbsentPitfall> absent_pitfalls() { return {std::begin(kAbsent), std::end(kAbsent)}; }

}  // namespace gbl
