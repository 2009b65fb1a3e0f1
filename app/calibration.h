#pragma once
// What each kind of work costs on the device at hand, measured once and kept by driver and device: what lights.method=auto
// chooses by.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/validate.h"
#include "renderer/frame/weight_fit.h"
#include "renderer/gl/device.h"
#include "renderer/passes/frame.h"

namespace gbl {

// Times of the methods in some set-ups of `scene`, small lights and large ones, few and many. s: size and the rest.
std::vector<MeasuredWork> measure_work(Renderer&, const GpuScene& scene, const Settings& s, const DeviceLimits&);

// $XDG_STATE_HOME/gbufferlab/calibration.json; empty: the environment names no folder.
std::optional<std::filesystem::path> calibration_file();

// Adds to the file, or replaces what was there of this device. Error(unfinished) if it cannot be written.
void keep_calibration(const std::filesystem::path&, const gl::Device&, const WorkWeights&);

// Those of this device from the file; else llvmpipe's, and a guess on any other device. `trouble`: why a file that is there
// cannot be used; empty: nothing.
WorkWeights weights_for(const std::optional<std::filesystem::path>&, const gl::Device&, std::string& trouble);

}  // namespace gbl
