#pragma once
// What one frame is drawn into and remembers until the next: textures, canvases beside them, what the CPU has uploaded,
// timers and read-backs. Frames of different settings may share it in turn.
#include <memory>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/readback.h"
#include "renderer/gl/timer.h"
#include "renderer/light/light_clusters.h"
#include "renderer/light/shadow_maps.h"
#include "renderer/passes/canvases.h"

namespace gbl {

// What the CPU uploads for a frame.
struct Uploads {
  gl::Buffer frame_block;
  gl::Texture light_data, instance_data;
  gl::Texture light_lists;               // of the clustered method …
  LightClusters clusters;                // … and what they were made from
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
  gl::Texture depth, records;
  gl::Framebuffer framebuffer;
  // What the tiles hold, so that what has not changed is not drawn again:
  std::weak_ptr<const Scene> scene;
  Settings drawn_as;  // less what maps do not depend on
  std::vector<ShadowMap> held;
};

struct Targets {
  FrameTextures frame;
  Canvases canvases;
  Uploads uploads;
  ShadowTargets shadows;
  gl::PassTimers timers;
  ReadBacks reads;
  std::shared_ptr<const ResolvedFrame> drawn;  // the frame drawn last; null before the first
};

}  // namespace gbl
