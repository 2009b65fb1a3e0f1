#include "renderer/base/limits.h"

namespace gbl {
namespace {

constexpr Limit kLimits[] = {
    {"text-bytes", kMostTextBytes, "bytes of a text file"},
    {"shader-bytes", kMostShaderBytes, "bytes of a layout's file or of an answer to an exercise"},
    {"json-depth", kMostJsonDepth, "nesting of objects and lists in JSON text"},
    {"picture-side", kMostPictureSide, "pixels along one side of a PNG or EXR"},
    {"exr-header-bytes", kMostExrHeaderBytes, "bytes of an EXR's header"},
    {"lights", kMaxLights, "lights of a rig or of settings"},
    {"study-cases", kMostStudyCases, "cases of a study"},
    {"study-axes", kMostStudyAxes, "options of a study made from options"},
    {"study-cameras", kMostStudyCameras, "the number of a camera that a study draws by chance"},
    {"figure-side", kMostFigureSide, "pixels along one side of a figure's frame"},
    {"figure-frames", kMostFigureFrames, "frames of a figure that moves"},
    {"pipe-wait-ms", kPipeWaitMs, "milliseconds that a pipe is waited for"},
    {"answer-seconds", static_cast<uint64_t>(kAnswerSeconds),
     "seconds that the judging of one answer takes, unless --limit says more"},
};

}  // namespace

std::span<const Limit> file_limits() { return kLimits; }

}  // namespace gbl
