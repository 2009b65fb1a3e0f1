#include "renderer/passes/targets.h"

#include "renderer/gl/pass_state.h"
#include "renderer/passes/frame_block.h"

namespace gbl {
namespace {

bool same(const std::vector<Attachment>& a, const std::vector<Attachment>& b) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (std::string_view(a[i].name) != b[i].name || a[i].format != b[i].format) return false;
  return true;
}

Canvas& made(std::optional<Canvas>& canvas, const gl::TextureDesc& desc, const gl::Texture* depth = nullptr) {
  if (!canvas) canvas = make_canvas(desc, depth);
  return *canvas;
}

constexpr int kSamples = 4;

// A pass draws into what it writes first; the sum that geometry began is lit as well, and what is drawn after the
// lighting with geometry needs its depth.
bool draws_into(const Attachment& a, Pass pass, Shading shading) {
  if (a.written_by == pass) return true;
  if (pass == Pass::lighting) return a.stores == Stores::light;
  return pass == Pass::combine && a.stores == Stores::depth && shading != Shading::deferred;
}

double mib_of(const gl::Texture& t) { return double(t.size.x) * t.size.y * row(t.format).bytes / (1 << 20); }

}  // namespace

Canvas make_canvas(const gl::TextureDesc& desc, const gl::Texture* depth) {
  Canvas c;
  c.texture = gl::make_texture(desc);
  c.framebuffer = gl::make_framebuffer({.colours = {&c.texture}, .depth = depth, .label = desc.label});
  return c;
}

Targets::Samples Targets::make_sampled(glm::ivec2 size, const std::vector<Attachment>& wanted) {
  Samples out;
  std::vector<size_t> colours;
  size_t depth = 0;
  for (const Attachment& a : wanted) {
    if (a.written_by != Pass::geometry) continue;
    if (a.stores == Stores::depth) {
      depth = out.buffers.size();
      out.stencil = row(a.format).stencil;
    } else
      colours.push_back(out.buffers.size());
    out.buffers.push_back(gl::make_samples(size, a.format, kSamples, a.name));
  }
  std::vector<const gl::Renderbuffer*> attached;
  for (const size_t i : colours) attached.push_back(&out.buffers[i]);
  out.framebuffer = gl::make_sample_framebuffer(attached, out.buffers[depth], out.stencil, "gbuffer.samples");
  out.colour_count = static_cast<int>(colours.size());
  return out;
}

const gl::Framebuffer& Targets::geometry_framebuffer() const {
  return samples_ ? samples_->framebuffer : framebuffer(Pass::geometry);
}

// One attachment at a time, and each mean as the driver makes it; integers and depth take one of the samples.
void Targets::resolve_samples() const {
  if (!samples_) return;
  gl::apply({});
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_->framebuffer.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer(Pass::geometry).id());
  const GLbitfield depth_bits = GL_DEPTH_BUFFER_BIT | (samples_->stencil ? GL_STENCIL_BUFFER_BIT : 0u);
  glDepthMask(true);
  glStencilMask(0xff);
  std::vector<GLenum> all;
  for (int i = 0; i < samples_->colour_count; ++i) {
    const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    std::vector<GLenum> only(static_cast<size_t>(i) + 1, GL_NONE);
    only.back() = slot;
    glReadBuffer(slot);
    glDrawBuffers(static_cast<GLsizei>(only.size()), only.data());
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT | (i == 0 ? depth_bits : 0u),
                      GL_NEAREST);
    all.push_back(slot);
  }
  glDrawBuffers(static_cast<GLsizei>(all.size()), all.data());
}

void Targets::prepare(const Settings& s) {
  std::vector<Attachment> wanted = gbl::attachments(s);
  const Shading shading = shading_of(s.lights.method);
  const bool multisampled = s.antialias == Antialias::msaa_resolved && shading != Shading::forward;
  if (size_ == s.size && same(wanted, attachments_) && shading == shading_ && multisampled == multisampled_) return;
  std::vector<gl::Texture> textures;
  for (const Attachment& a : wanted)
    textures.push_back(gl::make_texture({.size = s.size, .format = a.format, .label = a.name}));
  std::array<gl::Framebuffer, 3> framebuffers;
  for (const Pass pass : {Pass::geometry, Pass::lighting, Pass::combine}) {
    gl::FramebufferDesc desc{.label = pass == Pass::geometry ? "gbuffer" : pass == Pass::lighting ? "light" : "lit"};
    for (size_t i = 0; i < wanted.size(); ++i) {
      if (!draws_into(wanted[i], pass, shading)) continue;
      if (row(wanted[i].format).numeric == Numeric::depth)
        desc.depth = &textures[i];
      else
        desc.colours.push_back(&textures[i]);
    }
    if (desc.depth || !desc.colours.empty()) framebuffers[static_cast<int>(pass)] = gl::make_framebuffer(desc);
  }
  std::optional<Samples> samples;
  if (multisampled) samples = make_sampled(s.size, wanted);
  // Everything new exists: only now let go of the old.
  for (auto* c : {&composed_, &ids_, &counts_}) c->reset();  // they share depth attachments
  counts_with_depth_ = {}, counts_depth_ = {};
  samples_ = std::move(samples);
  multisampled_ = multisampled;
  shading_ = shading;
  if (size_ != s.size) {
    for (auto& v : views_) v.reset();
    for (auto* c : {&counts_lit_, &count_sums_, &unblurred_, &errors_}) c->reset();
  }
  size_ = s.size;
  attachments_ = std::move(wanted);
  textures_ = std::move(textures);
  framebuffers_ = std::move(framebuffers);
}

const gl::Texture* Targets::texture(Stores what) const {
  for (size_t i = 0; i < attachments_.size(); ++i)
    if (attachments_[i].stores == what) return &textures_[i];
  return nullptr;
}

const gl::Framebuffer& Targets::framebuffer(Pass pass) const { return framebuffers_[static_cast<int>(pass)]; }

double Targets::mib() const {
  double sum = 0;
  for (const gl::Texture& t : textures_) sum += mib_of(t);
  return sum;
}

Canvas& Targets::view(View v) {
  return made(views_[static_cast<int>(v)],
              {.size = size_, .format = Format::rgba8, .linear_filter = true, .label = row(v).id});
}

const Canvas* Targets::drawn_view(View v) const {
  const auto& canvas = views_[static_cast<int>(v)];
  return canvas ? &*canvas : nullptr;
}

Canvas& Targets::composed() {
  if (!composed_)
    composed_depth_ =
        gl::make_texture({.size = size_, .format = texture(Stores::depth)->format, .label = "composed.depth"});
  return made(composed_, {.size = size_, .format = Format::rgba32f, .label = "composed"}, &composed_depth_);
}

Canvas& Targets::counts() {
  return made(counts_, {.size = size_, .format = Format::rgba32f, .label = "counts"}, texture(Stores::light_depth));
}
const gl::Framebuffer& Targets::counts_with_depth() {
  if (!counts_with_depth_) {
    counts_depth_ = gl::make_texture({.size = size_, .format = Format::d32f, .label = "counts.depth"});
    counts_with_depth_ =
        gl::make_framebuffer({.colours = {&counts().texture}, .depth = &counts_depth_, .label = "counts"});
  }
  return counts_with_depth_;
}
Canvas& Targets::unblurred() {
  return made(unblurred_, {.size = size_, .format = Format::rgba32f, .label = "unblurred"});
}
Canvas& Targets::ids() {
  return made(ids_, {.size = size_, .format = Format::r32ui, .label = "ids"}, texture(Stores::depth));
}
Canvas& Targets::counts_lit() {
  return made(counts_lit_, {.size = size_, .format = Format::r32f, .label = "counts.lit"});
}
Canvas& Targets::count_sums() {
  return made(count_sums_,
              {.size = (size_ + COUNT_BLOCK - 1) / COUNT_BLOCK, .format = Format::rgba32f, .label = "counts.sums"});
}
Canvas& Targets::errors() { return made(errors_, {.size = size_, .format = Format::rgba32f, .label = "errors"}); }
Canvas& Targets::probe() {
  return made(probe_, {.size = {PROBE_FIELDS, 1}, .format = Format::rgba32f, .label = "probe"});
}

}  // namespace gbl
