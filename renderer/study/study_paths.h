#pragma once
// What a study may set, by path: every option but the views, which a measurement does not look at, and a few paths of
// its own that stand for several options at once.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/options/options.h"
#include "renderer/scene/scene.h"

namespace gbl {

using Coordinate = Assignment;  // a path and what is varied there, or shared by all cases

using SceneFn = std::function<std::shared_ptr<const Scene>(const std::string& name)>;

// Scenes by name, each opened once.
class SceneCache {
 public:
  explicit SceneCache(SceneFn open) : open_(std::move(open)) {}
  const Scene& get(const std::string& name);

 private:
  SceneFn open_;
  std::map<std::string, std::shared_ptr<const Scene>> scenes_;
};

// One row each, in the order in which they are applied; all other options come after them.
struct StudyPath {
  const char* path;
  const char* help;
  OptionValue (*checked)(const OptionValue&);                 // in the one form that is compared and printed, or Error
  void (*apply)(Settings&, const OptionValue&, SceneCache&);  // a checked value
  std::optional<OptionValue> (*of)(const Settings&);          // what these settings have; empty: they do not say
};
std::span<const StudyPath> study_paths();

void check_path(std::string_view path);  // Error(bad_input) with the nearest paths if a study cannot set it

// The value in the one form that is compared and printed; Error(bad_input) names the path and what it can be.
OptionValue checked_value(std::string_view path, const OptionValue&);

// All of them, whatever their order, in the order that study_paths() says. Neither a preset nor a scene: the default
// scene with its camera. Without a size: 640 x 360. Views are the defaults.
Settings settings_of(const std::vector<Coordinate>& checked, SceneCache&);

// What the coordinates say of a path, or else the settings.
std::optional<OptionValue> value_at(std::string_view path, const std::vector<Coordinate>&, const Settings&);

// "lights.method=volumes": texts without quotes.
std::string text_of(const Coordinate&);

}  // namespace gbl
