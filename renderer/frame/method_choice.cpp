#include "renderer/frame/method_choice.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/frame/attachments.h"
#include "renderer/frame/validate.h"

namespace gbl {
namespace {

struct Candidate {
  LightMethod method;
  LightWork work;
};

Settings with(Settings s, LightMethod method) {
  s.lights.method = method;
  return s;
}

// What is stored must not depend on a choice that changes from frame to frame.
bool same_targets(const Settings& a, const Settings& b) {
  const std::vector<Attachment> x = attachments(a), y = attachments(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const Attachment& i, const Attachment& k) {
    return i.stores == k.stores && i.format == k.format;
  });
}

// Sound in what decides about pairs; what is stored is none of the method's business.
bool chosen_soundly(const Settings& s) {
  for (const Unsound& u : unsound_choices(s))
    if (u.path.starts_with("lights.")) return false;
  return true;
}

bool usable(const Settings& s, LightMethod method, FeatureSet features) {
  const Settings chosen = with(s, method);
  if (shading_of(method) != Shading::deferred || !features.has(row(method).needs)) return false;
  return chosen_soundly(chosen) && same_targets(s, chosen) && validate(chosen, {features}).empty();
}

std::string rounded(double pairs) {
  if (pairs < 1e3) return fmt::format("{:.0f}", pairs);
  return pairs < 1e6 ? fmt::format("{:.0f} k", pairs / 1e3) : fmt::format("{:.1f} M", pairs / 1e6);
}

// As estimated: the frame's counts may differ by a factor of two or so.
std::string reason_for(const Candidate& best, const Candidate& plain) {
  if (plain.work.shaded == 0) return "there is no light";
  if (best.method == plain.method) return "the lights reach so many pixels that leaving any out costs more";
  if (best.work.tested > 0.95 * plain.work.tested) return "as many pairs as the plain loop, each at less cost";
  return fmt::format("about {} pairs tested instead of {}", rounded(best.work.tested), rounded(plain.work.tested));
}

// Work is weighed as on another device.
std::string with_doubt(const std::string& reason) {
  return work_weights().guessed ? reason + "; a guess: this device was not measured (bench --calibrate)" : reason;
}

}  // namespace

MethodChoice choose_method(const Settings& s, const std::vector<Light>& lights, FeatureSet features) {
  if (s.lights.method != LightMethod::auto_) return {s.lights.method, ""};
  const LightsInView view = lights_in_view(s, lights);
  const auto candidate = [&](LightMethod m) { return Candidate{m, work_of(m, view)}; };
  const Candidate plain = candidate(LightMethod::fullscreen);
  Candidate best = plain;
  for (const ValueRow& r : rows<LightMethod>()) {
    const auto method = static_cast<LightMethod>(r.value);
    if (method == LightMethod::auto_) continue;
    const Candidate other = candidate(method);
    if (other.work.units < best.work.units && usable(s, method, features)) best = other;
  }
  return {best.method, with_doubt(reason_for(best, plain))};
}

}  // namespace gbl
