#pragma once
// A study is data: base x permute over paths, expanded by a pure function.
//   {"version": 1, "name": "normals", "label": "Normal encodings",
//    "base": {"scene": "builtin:room"},
//    "permute": {"normal.encoding": ["oct8", "oct16"], "normal.space": ["world", "view"]},
//    "skip": [{"normal.encoding": "oct8", "normal.space": ["view"]}],
//    "x": "bytes_per_pixel", "y": "normal_deg_p99", "family": "normal.space"}
// permute is a product, its last path the fastest; an array of such objects is their union, in order, and none is the
// base alone. A case that matches all members of one entry of skip is left out. Paths: renderer/study/study_paths.h.
#include "renderer/base/json_fwd.h"
#include "renderer/frame/validate.h"
#include "renderer/study/study_paths.h"

namespace gbl {

struct PathValues {
  std::string path;
  std::vector<OptionValue> values;
};

struct StudySpec {
  std::string where;  // the file, for messages
  std::string name, label;
  std::vector<Coordinate> base;
  std::vector<std::vector<PathValues>> permute;  // a union of products
  std::vector<std::vector<PathValues>> skip;
  std::string x, y, family;          // of the chart, unless another is asked for
  std::shared_ptr<const Json> json;  // as read, with what was given in its base
};

// Every path, value and column has been checked. Error(bad_input) names file, path, what is wrong and how to fix it.
StudySpec parse_study(std::string_view text, std::string_view where);
// A built-in study by its name, or else a file.
StudySpec load_study(const std::string& name_or_file);

// The same study of something else: what is given stands in the place of the base's, and a scene brings its own camera.
// Error(bad_input) where the study varies what is given by `explicitly`; what `state` says of it is passed over.
StudySpec with_given(StudySpec, const std::vector<Coordinate>& state, const std::vector<Coordinate>& explicitly);

struct BuiltinStudy {
  std::string id, label;
};
std::vector<BuiltinStudy> builtin_studies();  // sorted

struct StudyCase {
  std::string id;  // "path=value path=value": the coordinates that vary, in order
  Settings settings;
  std::vector<Coordinate> at;
};

enum class LeftOutBy { rule, invalid, duplicate };
struct LeftOut {
  std::string id;
  LeftOutBy by;
  std::string reason;
};

struct StudyPlan {
  std::string study;
  std::vector<StudyCase> cases;
  std::vector<LeftOut> left_out;
};

// Left out are cases that a rule skips, that this device cannot draw, and that are drawn as an earlier case is: equal
// in every option that is in use. Scenes are opened for their cameras and looks only.
StudyPlan expand(const StudySpec&, const SceneFn&, const DeviceLimits&);

}  // namespace gbl
