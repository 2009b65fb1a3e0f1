#include "renderer/study/advice/advisor.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "renderer/base/error.h"
#include "renderer/frame/attachments.h"
#include "renderer/frame/estimate.h"
#include "renderer/frame/frame_lights.h"
#include "renderer/frame/method_choice.h"
#include "renderer/frame/resolve.h"
#include "renderer/light/lights.h"
#include "renderer/options/options.h"
#include "renderer/study/advice/axis_values.h"
#include "renderer/study/advice/sight_advice.h"

namespace gbl {
namespace {

constexpr size_t kMostSetups = 300;    // whole set-ups tried before giving up
constexpr double kMostWork = 6;        // times the least estimated, to be measured at all
constexpr size_t kMeasuredSetups = 4;  // that hold and are measured where the cost is no count of bytes

int bytes_of(const Settings& s, const Scene& scene) {
  const Settings r = resolve(s, scene).settings;
  return gbuffer_bytes_per_pixel(r) + accumulation_bytes_per_pixel(r);
}

class Advisor {
 public:
  Advisor(const Settings& truth, const Scene& scene, const ErrorBudget& budget, AdviceCost cost,
          const DeviceLimits& limits, const JudgeFn& judge, const CostFn& measure, const AdviceProgress& progress,
          const std::atomic<bool>& cancel)
      : scene_(scene),
        budget_(budget),
        cost_(cost),
        limits_(limits),
        judge_(judge),
        measure_(measure),
        progress_(progress),
        cancel_(cancel),
        truth_(truth),
        base_(lossless(lit_alone(truth), limits.features)) {
    base_.lights.method = choose_method(base_, lights_of(truth, scene), limits.features).method;
  }

  Advice advise() {
    try {
      look();
    } catch (const Error& e) {
      if (e.code() != ExitCode::interrupted) throw;
      advice_.stopped = true;
      if (!advice_.best) advice_.best = so_far_;
    }
    if (advice_.best) say_what_is_left_out(advice_.best->settings);
    return std::move(advice_);
  }

 private:
  void look() {
    for (const Values& axis : axis_values(limits_)) axes_.push_back(values_that_hold(axis));
    if (cost_ == AdviceCost::time)
      take_two(measured(setups_that_hold()));
    else
      take_two(two_cheapest());
    look_at_sights();
  }

  // From every camera.
  Tried worst_of(const std::vector<Assignment>& values, const Settings& s) const {
    step(in_words(values));
    Tried out{values, true, 0, {}};
    for (int camera = 0; camera < kAdviceCameras; ++camera) {
      const BoundCheck b = judge_(s, camera);
      if (camera == 0 || b.share_over() > out.worst.share_over()) out.camera = camera, out.worst = b;
    }
    out.holds = budget_.holds(out.worst);
    return out;
  }

  // What is not stored comes on top of the set-up that stores the rest.
  void look_at_sights() {
    if (!advice_.best || truth_ == lit_alone(truth_)) return;
    SightAdvice sights =
        advise_sights(truth_, base_, scene_, budget_, limits_,
                      [&](const std::vector<Assignment>& v, const Settings& s) { return worst_of(v, s); });
    advice_.sights = std::move(sights.choices), sights_left_out_ = std::move(sights.left_out);
    for (std::optional<AdvisedSetup>* setup : {&advice_.best, &advice_.runner_up}) {
      if (!*setup) continue;
      Settings& s = (*setup)->settings;
      s.shadows = truth_.shadows, s.reflections = truth_.reflections, s.height_map = truth_.height_map;
      if (!sights.chosen.empty()) apply_values(s, sights.chosen);
      if (cost_ == AdviceCost::time) (*setup)->cost = measure_(s);
      (*setup)->together = worst_of(setup_values(s), s);
    }
    if (cost_ == AdviceCost::time && advice_.runner_up && cheaper(*advice_.runner_up, *advice_.best))
      std::swap(advice_.best, advice_.runner_up);
  }

  void step(const std::string& what) const {
    if (cancel_) throw Error(ExitCode::interrupted, "advice", "stopped");
    progress_(what);
  }

  // From every camera, or until one fails.
  Tried tried(const std::vector<Assignment>& values, const Settings& s) const {
    step(in_words(values));
    Tried out{values, true, 0, {}};
    for (int camera = 0; camera < kAdviceCameras && out.holds; ++camera) {
      const BoundCheck b = judge_(s, camera);
      out.holds = budget_.holds(b);
      if (camera > 0 && out.holds && b.worst <= out.worst.worst) continue;
      out.camera = camera, out.worst = b;
    }
    return out;
  }

  Values values_that_hold(const Values& all) {
    Values out;
    for (const Patch& patch : all) {
      Settings s = base_;
      apply_values(s, patch);
      if (!validate(s, limits_).empty()) continue;
      advice_.values.push_back(tried(patch, s));
      if (!advice_.values.back().holds) continue;
      out.push_back(patch);
      const int bytes = bytes_of(s, scene_);
      if (!so_far_ || bytes < so_far_->bytes_per_pixel)
        so_far_ = AdvisedSetup{s, cost_ == AdviceCost::bytes ? bytes : NAN, bytes, advice_.values.back()};
    }
    return out;
  }

  // All products of values that hold alone, with this method, fewest bytes first; each way to store once.
  std::vector<AdvisedSetup> products(LightMethod method) const {
    std::vector<AdvisedSetup> out{{base_, 0, 0, {}}};
    out.front().settings.lights.method = method;
    for (const Values& axis : axes_) {
      std::vector<AdvisedSetup> longer;
      for (const AdvisedSetup& before : out)
        for (const Patch& patch : axis) {
          longer.push_back(before);
          apply_values(longer.back().settings, patch);
        }
      out = std::move(longer);
    }
    std::set<std::string> known;  // what a method does not use makes no other set-up
    std::erase_if(out, [&](const AdvisedSetup& a) {
      return !validate(a.settings, limits_).empty() || !known.insert(in_words(setup_values(a.settings))).second;
    });
    for (AdvisedSetup& a : out) a.cost = a.bytes_per_pixel = bytes_of(a.settings, scene_);
    std::stable_sort(out.begin(), out.end(), [](const AdvisedSetup& a, const AdvisedSetup& b) {
      return a.bytes_per_pixel < b.bytes_per_pixel;
    });
    return out;
  }

  // Bytes and pairs need no clock: from the cheapest up, the first that holds is the answer. The runner-up is the cheapest
  // with another method: another way to store under the same one would say little.
  std::vector<AdvisedSetup> two_cheapest() {
    std::vector<AdvisedSetup> out;
    size_t looked_at_since = 0;
    for (std::vector<AdvisedSetup>& setups : cost_ == AdviceCost::bytes ? by_bytes() : by_pairs())
      for (AdvisedSetup& a : setups) {
        if (!out.empty() && a.settings.lights.method == out.front().settings.lights.method) continue;
        if (!out.empty() && ++looked_at_since > kMostSetups) return out;
        a.proof = tried(setup_values(a.settings), a.settings);
        if (!a.proof.holds) {
          if (out.empty()) advice_.rejected.push_back(std::move(a.proof));
          continue;
        }
        out.push_back(std::move(a));
        if (out.size() == 2) return out;
        advice_.best = out.front();  // whoever stops now has the answer
      }
    return out;
  }

  // One method of each kind of shading: what is stored follows from the kind.
  std::vector<std::vector<AdvisedSetup>> by_bytes() const {
    std::vector<AdvisedSetup> all;
    for (const LightMethod m : {base_.lights.method, LightMethod::prepass, LightMethod::forward})
      for (AdvisedSetup& a : products(m)) all.push_back(std::move(a));
    std::stable_sort(all.begin(), all.end(),
                     [](const AdvisedSetup& a, const AdvisedSetup& b) { return a.cost < b.cost; });
    return {std::move(all)};
  }

  // Methods by their pairs, which do not depend on what is stored; of one method fewest bytes first.
  std::vector<std::vector<AdvisedSetup>> by_pairs() {
    std::vector<std::pair<double, LightMethod>> methods;
    for_sound_rows<LightMethod>(limits_, [&](const ValueRow& r) {
      Settings s = base_;
      s.lights.method = static_cast<LightMethod>(r.value);
      if (s.lights.method == LightMethod::prepass) s.accumulation.targets = AccumulationTargets::split;
      if (s.lights.method == LightMethod::auto_ || !validate(s, limits_).empty()) return;
      step(fmt::format("counting the pairs of lights.method={}", r.id));
      methods.emplace_back(measure_(s), s.lights.method);
    });
    std::stable_sort(methods.begin(), methods.end(), [](auto& a, auto& b) { return a.first < b.first; });
    std::vector<std::vector<AdvisedSetup>> out;
    for (const auto& [pairs, method] : methods) {
      out.push_back(products(method));
      for (AdvisedSetup& a : out.back()) a.cost = pairs;
    }
    return out;
  }

  std::vector<AdvisedSetup> setups_that_hold() {
    std::vector<AdvisedSetup> out;
    size_t looked_at = 0;
    for (AdvisedSetup& a : products(base_.lights.method)) {
      if (out.size() == kMeasuredSetups || ++looked_at > kMostSetups) break;
      a.proof = tried(setup_values(a.settings), a.settings);
      if (a.proof.holds)
        out.push_back(std::move(a));
      else if (out.empty())
        advice_.rejected.push_back(std::move(a.proof));
    }
    return out;
  }

  // The first with every sound method, the others with the method that was the cheapest.
  std::vector<AdvisedSetup> measured(const std::vector<AdvisedSetup>& holding) {
    std::vector<AdvisedSetup> out;
    if (holding.empty()) return out;
    for (AdvisedSetup& a : with_each_method(holding.front())) append_measured(out, std::move(a));
    const auto cheapest = std::min_element(out.begin(), out.end(), cheaper);
    if (cheapest == out.end()) return out;
    const LightMethod method = cheapest->settings.lights.method;
    if (shading_of(method) == Shading::deferred)
      for (size_t i = 1; i < holding.size(); ++i) {
        AdvisedSetup a = holding[i];
        a.settings.lights.method = method;
        append_measured(out, std::move(a));
      }
    std::stable_sort(out.begin(), out.end(), cheaper);
    return out;
  }

  // Not those whose work is estimated at many times the least: measuring them would take longer than all the rest.
  std::vector<AdvisedSetup> with_each_method(const AdvisedSetup& setup) {
    std::vector<std::pair<double, AdvisedSetup>> all;
    for_sound_rows<LightMethod>(limits_, [&](const ValueRow& r) {
      AdvisedSetup a = setup;
      LightMethod& method = a.settings.lights.method = static_cast<LightMethod>(r.value);
      if (method == LightMethod::auto_) return;
      if (method == LightMethod::prepass) a.settings.accumulation.targets = AccumulationTargets::split;
      all.emplace_back(estimate_work(a.settings, lights_of(a.settings, scene_)), std::move(a));
    });
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<AdvisedSetup> out;
    for (auto& [work, a] : all) {
      if (work <= kMostWork * all.front().first)
        out.push_back(std::move(a));
      else
        advice_.left_out.push_back(fmt::format("lights.method={}: its work is estimated at {:.0f} times the least",
                                               row(a.settings.lights.method).id, work / all.front().first));
    }
    return out;
  }

  // A method of other stored bits is judged, too: forward and deferred lighting store less.
  void append_measured(std::vector<AdvisedSetup>& out, AdvisedSetup a) {
    if (!validate(a.settings, limits_).empty()) return;
    const std::vector<Assignment> values = setup_values(a.settings);
    if (shading_of(a.settings.lights.method) != Shading::deferred) {
      a.proof = tried(values, a.settings);
      if (!a.proof.holds) return advice_.rejected.push_back(a.proof);
    }
    step(fmt::format("measuring {}", in_words(values)));
    a.cost = measure_(a.settings);
    a.bytes_per_pixel = bytes_of(a.settings, scene_);
    if (!advice_.best || cheaper(a, *advice_.best)) advice_.best = a;
    advice_.measured.push_back(a);
    out.push_back(std::move(a));
  }

  static bool cheaper(const AdvisedSetup& a, const AdvisedSetup& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.bytes_per_pixel < b.bytes_per_pixel;
  }

  void take_two(const std::vector<AdvisedSetup>& sorted) {
    if (!sorted.empty()) advice_.best = sorted[0];
    if (sorted.size() > 1) advice_.runner_up = sorted[1];
  }

  // Values that would have been cheaper and failed, and what no material has.
  void say_what_is_left_out(const Settings& best) {
    for (const std::string& note : resolve(best, scene_).notes) advice_.left_out.push_back(note);
    const MaterialNeeds needs = needs_of(scene_, best.reflections == Reflections::on);
    const auto say_if = [&](bool missing, const char* what) {
      if (missing) advice_.left_out.push_back(fmt::format("{}: no material of the scene has any", what));
    };
    say_if(!needs.metal, "metal");
    say_if(!needs.emission, "emission");
    say_if(!needs.occlusion, "occlusion");
    for (const Tried& t : advice_.values)
      if (!t.holds)
        advice_.left_out.push_back(
            fmt::format("{}: {:.3g} % of the pixels are over the bound from camera {}, the worst by {:.3g} codes",
                        in_words(t.values), 100 * t.worst.share_over(), t.camera, 255 * t.worst.worst));
    for (const std::string& line : sights_left_out_) advice_.left_out.push_back(line);
  }

  const Scene& scene_;
  const ErrorBudget budget_;
  const AdviceCost cost_;
  const DeviceLimits limits_;
  const JudgeFn& judge_;
  const CostFn& measure_;
  const AdviceProgress& progress_;
  const std::atomic<bool>& cancel_;
  const Settings truth_;
  Settings base_;
  std::vector<std::string> sights_left_out_;
  std::vector<Values> axes_;            // of each, the values that hold alone
  std::optional<AdvisedSetup> so_far_;  // of the values alone: the fewest bytes that hold
  Advice advice_;
};

}  // namespace

std::vector<Assignment> setup_values(const Settings& s) {
  constexpr const char* kPaths[] = {"lights.method",        "layout",          "normal.encoding",
                                    "position.source",      "depth.format",    "accumulation.format",
                                    "accumulation.targets", "shadow.map-size", "shadow.max-lights",
                                    "reflect.method",       "reflect.size",    "parallax.method",
                                    "parallax.steps"};
  std::vector<Assignment> values;
  for (const char* path : kPaths)
    if (const Option& o = option(path); in_use(o, s)) values.push_back({path, o.get(s)});
  return values;
}

std::string in_words(const std::vector<Assignment>& values) {
  std::string out;
  for (const Assignment& a : values) out += fmt::format("{}{}={}", out.empty() ? "" : " ", a.path, plain(a.value));
  return out;
}

Advice advise(const Settings& truth, const Scene& scene, const ErrorBudget& budget, AdviceCost cost,
              const DeviceLimits& limits, const JudgeFn& judge, const CostFn& measure, const AdviceProgress& progress,
              const std::atomic<bool>& cancel) {
  return Advisor(truth, scene, budget, cost, limits, judge, measure, progress, cancel).advise();
}

}  // namespace gbl
