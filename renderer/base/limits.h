#pragma once
// What a file may ask of us, but for models (gltf/gltf_limits.h). Each is far above what people write and far below what would
// exhaust a small machine. `info` lists them.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace gbl {

inline constexpr size_t kMostTextBytes = size_t(256) << 20;  // a journal of 100 000 rows
inline constexpr size_t kMostShaderBytes = 1 << 20;          // of a layout's file or an exercise's answer
inline constexpr int kMostJsonDepth = 64;
inline constexpr int kMostPictureSide = 16384;                   // pixels: the largest frame and texture
inline constexpr size_t kMostExrHeaderBytes = size_t(16) << 20;  // a preview may be in it
inline constexpr int kMaxLights = 16384;
inline constexpr size_t kMostStudyCases = 100'000;
inline constexpr size_t kMostStudyAxes = 12;         // subsets of more are thousands
inline constexpr int kMostStudyCameras = 1'000'000;  // the number of one that is drawn by chance
inline constexpr int kMostFigureSide = 4096;         // pixels
inline constexpr int kMostFigureFrames = 1000;
inline constexpr int kPipeWaitMs = 3000;      // for who writes into a pipe that is read
inline constexpr double kAnswerSeconds = 60;  // `exercise --limit` chooses another

struct Limit {
  std::string_view id;
  uint64_t value;
  std::string_view what;
};
std::span<const Limit> file_limits();

}  // namespace gbl
