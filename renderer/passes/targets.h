#pragma once
// What one frame is drawn into and remembers until the next: textures, canvases beside them, what the CPU has uploaded,
// timers and read-backs. Frames of different settings may share it in turn.
#include <memory>
#include <optional>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/readback.h"
#include "renderer/gl/texel_buffer.h"
#include "renderer/gl/timer.h"
#include "renderer/light/light_clusters.h"
#include "renderer/light/shadow_maps.h"
#include "renderer/passes/canvases.h"
#include "renderer/passes/tessellation.h"
#include "renderer/reflection/mirrors.h"

namespace gbl {

// What the CPU uploads for a frame.
struct Uploads {
  gl::Buffer frame_block;
  gl::TexelBuffer light_data, light_traits, instance_data;
  std::vector<glm::vec4> record_texels;  // scratch, kept so that a steady frame allocates nothing
};

// Of one pixel: its values in a row of texels, a field of PixelProbe each, and its attachments' texels.
struct ProbeReads {
  glm::ivec2 pixel{0};
  gl::AsyncRead values;
  gl::AsyncTexels stored;
  void drop() { values.drop(), stored.drop(); }
};

// Answers under way.
struct ReadBacks {
  gl::AsyncRead counts, error;
  ProbeReads probe;
  void drop() { counts.drop(), probe.drop(), error.drop(); }  // they are of another frame than the next
};

// Depth as lights see it, all maps side by side, and what each map is: rows of records.
struct ShadowTargets {
  gl::Texture depth;
  gl::TexelBuffer records;
  gl::Framebuffer framebuffer;
  // What the tiles hold, so that what has not changed is not drawn again:
  std::weak_ptr<const Scene> scene;
  Settings drawn_as;  // less what maps do not depend on
  std::vector<ShadowMap> held;
  int tessellation = 0;  // Tessellation::made() then
  int reloads = 0;       // ProgramCache::reloads() then
};

// Of the clustered method: what is seen of the picture's tiles, and their lists.
struct ClusterTargets {
  std::optional<Canvas> depths;  // two DepthSpan of each block of pixels
  LightClusters clusters;
  gl::TexelBuffer lists;
  double ms = 0;  // of the CPU, when they were last made: to cut the view, to list and to upload; no waiting
};

struct Targets;

// What a mirror's picture leaves out: the mirror, and what lies behind its plane.
struct Cut {
  bool nested = false;  // it is a picture within another frame, whose timer runs
  int object = 0;       // from 1; 0: none
  std::optional<Plane> behind;
  const Tessellation* tessellation = nullptr;  // of the frame around it
};

// What mirrors show.
struct MirrorTargets {
  std::unique_ptr<Targets> flat_frame, side_frame;  // into which all of a kind are drawn in turn
  std::vector<Canvas> flat;                         // of each flat mirror, as large as the frame, its columns reversed
  Canvas sides;                                     // of the others: a row each, six squares a row
  gl::Framebuffer onto_lit;
  // What the squares hold, so that what has not changed is not drawn again:
  std::weak_ptr<const Scene> scene;
  std::vector<Settings> held;
  std::vector<Light> lights;  // a rig's file may have changed
  int tessellation = 0;       // Tessellation::made() then
  int reloads = 0;            // ProgramCache::reloads() then
};

struct Targets {
  FrameTextures frame;
  Canvases canvases;
  Uploads uploads;
  Tessellation tessellation;
  ShadowTargets shadows;
  MirrorTargets mirrors;
  ClusterTargets clusters;
  Cut cut;
  gl::PassTimers timers;
  ReadBacks reads;
  std::shared_ptr<const ResolvedFrame> drawn;  // the frame drawn last; null before the first
};

}  // namespace gbl
