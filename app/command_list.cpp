// `list WHAT`: every table of the lab as text, Markdown or JSON. The same rows fill the docs.
#include <fmt/format.h>
#include <functional>
#include <optional>

#include "app/commands.h"
#include "app/docs_pages.h"
#include "app/headless.h"
#include "app/manual.h"
#include "renderer/base/json.h"
#include "renderer/exercises/exercise.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/gbuffer/position_source.h"
#include "renderer/gl/device.h"
#include "renderer/lessons/lessons.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "renderer/pitfalls/mistakes.h"
#include "renderer/scenes/builtin_scenes.h"
#include "renderer/study/pitfalls/catalogue.h"
#include "renderer/study/study_spec.h"
#include "ui/ui.h"

namespace gbl {
namespace {

// One row: columns in order, ready for JSON; `needs` decides `available`.
struct ListRow {
  Json columns;
  Feature needs = Feature::none;
};
using Rows = std::vector<ListRow>;

Json base(const char* id, const char* label) {
  Json j;
  j["id"] = id;
  j["label"] = label;
  return j;
}

// A table of values: `sound` is null for truth rows.
template <class E>
Rows value_rows(bool of_truth = false) {
  Rows out;
  for (const ValueRow& r : rows<E>()) {
    Json j = base(r.id, r.label);
    j["sound"] = of_truth ? Json(nullptr) : Json(r.sound());
    j["pitfall"] = id_of(r.pitfall);
    j["help"] = r.help;
    j["cost"] = r.cost;
    j["source"] = r.source;
    out.push_back({j, r.needs});
  }
  return out;
}

template <class Table>
Rows named_rows(const Table& table) {
  Rows out;
  for (const auto& r : table) {
    Json j = base(r.id, r.label);
    j["sound"] = nullptr;
    j["help"] = r.help;
    out.push_back({j});
  }
  return out;
}

void append_degrees(Json& j, const std::optional<Degrees>& d, const std::string& suffix) {
  j["mean_deg" + suffix] = d ? Json(d->mean) : Json(nullptr);
  j["p99_deg" + suffix] = d ? Json(d->p99) : Json(nullptr);
  j["max_deg" + suffix] = d ? Json(d->max) : Json(nullptr);
}

// The numbers stand before the long texts: nobody should have to scroll for them.
Rows encoding_rows() {
  Rows out = value_rows<NormalEncoding>();
  for (size_t i = 0; i < out.size(); ++i) {
    const EncodingRow& e = row_of(static_cast<NormalEncoding>(i));
    Json j;
    for (const auto& [key, value] : out[i].columns.items()) {
      if (key == "help") {
        j["bits"] = e.bits();
        append_degrees(j, e.error, "");
        append_degrees(j, e.toward_zero, "_toward_zero");
      }
      j[key] = value;
    }
    out[i].columns = j;
  }
  return out;
}

// Stored sources by their ids; positions from depth by format and reconstruction: errors in world units.
Rows position_list() {
  Rows out;
  for (const PositionRow& r : position_rows()) {
    const bool from_depth = r.source == PositionSource::depth;
    const ValueRow& source = row(r.source);
    const ValueRow& how = from_depth ? row(r.reconstruct) : source;
    Json j = base(id_of(r).c_str(), how.label);
    j["sound"] = source.sound() && how.sound();
    for (size_t k = 0; k < std::size(kPositionRanges); ++k)
      j[fmt::format("max_error_at_{:g}", kPositionRanges[k])] = r.max_error[k];
    j["help"] = how.help;
    j["cost"] = from_depth ? row(r.format).cost : source.cost;
    j["source"] = how.source;
    out.push_back({j, from_depth ? row(r.format).needs : Feature::none});
  }
  return out;
}

Rows mistake_rows() {
  Rows out;
  for (const MistakeRow& m : mistakes()) {
    Json j = base(m.id, m.label);
    j["sound"] = false;
    j["help"] = m.help;
    j["source"] = m.source;
    out.push_back({j});
  }
  return out;
}

Rows view_rows() {
  Rows out;
  for (const ViewRow& v : views()) {
    Json j = base(v.id, v.label);
    j["sound"] = nullptr;
    j["key"] = v.key;
    j["help"] = v.sentence;
    out.push_back({j});
  }
  return out;
}

Rows option_rows() {
  Rows out;
  for (const Option& o : options()) {
    Json j = base(o.path, o.label);
    j["sound"] = nullptr;
    j["group"] = group_id(o.group);
    j["key"] = o.key;
    j["help"] = o.help;
    if (o.kind == Kind::choice) {
      j["values"] = Json::array();
      for (const ValueRow& r : o.values) j["values"].push_back(r.id);
    } else if (o.min != o.max) {
      j["range"] = Json::array({o.min, o.max});
    }
    if (*o.unit) j["unit"] = o.unit;
    out.push_back({j});
  }
  return out;
}

Rows key_list() {
  Rows out;
  std::vector<ui::KeyRow> rows = ui::key_rows();
  for (ui::KeyRow& r : ui::mouse_rows()) rows.push_back(std::move(r));
  for (const ui::KeyRow& k : rows) {
    Json j = base(k.id.c_str(), k.help.c_str());
    j["sound"] = nullptr;
    j["key"] = k.key;
    out.push_back({j});
  }
  return out;
}

Rows lesson_rows() {
  Rows out;
  for (const std::string& id : lesson_ids()) {
    const Lesson lesson = load_lesson(id);
    Json j = base(id.c_str(), lesson.title.c_str());
    j["sound"] = nullptr;
    j["steps"] = lesson.steps.size();
    out.push_back({j});
  }
  return out;
}

Rows exercise_rows() {
  Rows out;
  for (const Exercise& e : load_exercises()) {
    Json j = base(e.id.c_str(), e.title.c_str());
    j["sound"] = nullptr;
    j["answer"] = id_of(e.answer), j["source"] = e.source;
    out.push_back({j});
  }
  return out;
}

// "lights.cull=back lights.volume.clip=none"
std::string words_of(const std::vector<Assignment>& patch) {
  std::string out;
  for (const Assignment& a : patch) out += fmt::format("{}{}={}", out.empty() ? "" : " ", a.path, plain(a.value));
  return out;
}

Rows pitfall_rows() {
  Rows out;
  for (const PitfallEntry& e : load_pitfalls()) {
    Json j = base(e.id.c_str(), e.title.c_str());
    j["sound"] = nullptr;
    j["group"] = e.group;
    j["metric"] = e.metric;
    j["broken"] = words_of(e.broken), j["fixed"] = words_of(e.fixed);
    j["help"] = e.symptom;
    j["source"] = e.source;
    out.push_back({j});
  }
  return out;
}

Rows study_rows() {
  Rows out;
  for (const BuiltinStudy& study : builtin_studies()) {
    Json j = base(study.id.c_str(), study.label.c_str());
    j["sound"] = nullptr;
    out.push_back({j});
  }
  return out;
}

struct List {
  const char* id;
  std::function<Rows()> rows;
};
const List kLists[] = {
    {"presets", [] { return named_rows(presets()); }},
    {"scenes", [] { return named_rows(builtin_scenes()); }},
    {"layouts", [] { return value_rows<Layout>(); }},
    {"encodings", encoding_rows},
    {"positions", position_list},
    {"mistakes", mistake_rows},
    {"methods", [] { return value_rows<LightMethod>(); }},
    {"culls", [] { return value_rows<LightCull>(); }},
    {"views", view_rows},
    {"overlays", [] { return value_rows<VolumeOverlay>(true); }},
    {"options", option_rows},
    {"keys", key_list},
    {"pitfalls", pitfall_rows},
    {"lessons", lesson_rows},
    {"studies", study_rows},
    {"exercises", exercise_rows},
};

const List& list_called(const std::string& what) {
  std::vector<std::string_view> known;
  for (const List& l : kLists) {
    if (what == l.id) return l;
    known.push_back(l.id);
  }
  throw Error(ExitCode::bad_input, "list",
              what.empty() ? "name what to list" : fmt::format("nothing called '{}'", what), suggest(what, known));
}

// What this machine's driver has; empty and the reason when there is none.
struct Availability {
  std::optional<FeatureSet> features;
  std::string why_unknown;
};
Availability availability(const Arguments& a) {
  try {
    const HeadlessContext context(api_of(a));
    return {gl::probe_device(without_of(a)).features, ""};
  } catch (const Error& e) {
    if (e.code() != ExitCode::no_gl) throw;
    return {{}, e.what()};
  }
}

Json as_json(const Rows& rows_listed, const Availability& here) {
  Json all = Json::array();
  for (const ListRow& r : rows_listed) {
    Json j;
    for (const auto& [key, value] : r.columns.items()) {
      j[key] = value;
      if (key != "label") continue;
      j["available"] = here.features ? Json(here.features->has(r.needs)) : Json(nullptr);
      if (!here.features) j["reason"] = here.why_unknown;
    }
    all.push_back(j);
  }
  return all;
}

std::string cell(const Json& v) {
  if (v.is_string()) return v.get<std::string>();
  if (v.is_null()) return "";
  if (v.is_boolean()) return v.get<bool>() ? "yes" : "no";
  if (v.is_number_float()) return fmt::format("{:.4g}", v.get<double>());
  if (!v.is_array()) return v.dump();
  std::string all;
  for (const Json& part : v) all += (all.empty() ? "" : ", ") + cell(part);
  return all;
}

// Columns that say something in at least one row, in the rows' own order.
std::vector<std::string> columns_of(const Json& all) {
  std::vector<std::string> known, out;
  for (const Json& r : all)
    for (const auto& [key, value] : r.items())
      if (std::find(known.begin(), known.end(), key) == known.end()) known.push_back(key);
  for (const std::string& key : known)
    if (std::any_of(all.begin(), all.end(), [&](const Json& r) { return r.contains(key) && !cell(r[key]).empty(); }))
      out.push_back(key);
  return out;
}

std::string as_markdown(const Json& all, const std::vector<std::string>& columns) {
  std::string out = fmt::format("| {} |\n|{}\n", fmt::join(columns, " | "), [&] {
    std::string rule;
    for (size_t i = 0; i < columns.size(); ++i) rule += "---|";
    return rule;
  }());
  for (const Json& r : all) {
    for (const std::string& c : columns) out += "| " + (r.contains(c) ? cell(r[c]) : "") + " ";
    out += "|\n";
  }
  return out;
}

std::string as_text(const Json& all) {
  size_t width = 0;
  for (const Json& r : all) width = std::max(width, r["id"].get<std::string>().size());
  std::string out;
  for (const Json& r : all) {
    const std::string key = r.contains("key") && !cell(r["key"]).empty() ? "[" + cell(r["key"]) + "] " : "";
    const std::string pitfall =
        r.contains("pitfall") && !cell(r["pitfall"]).empty() ? "  UNSOUND: " + cell(r["pitfall"]) : "";
    const std::string values = r.contains("values") ? "  (" + cell(r["values"]) + ")" : "";
    const std::string help = r.contains("help") ? cell(r["help"]) : "";
    std::string numbers;
    for (const auto& [name, value] : r.items())
      if (value.is_number()) numbers += (numbers.empty() ? "  [" : ", ") + name + " " + cell(value);
    out += fmt::format("{:<{}}  {}{}{}{}{}{}\n", cell(r["id"]), width, key, cell(r["label"]),
                       help.empty() ? "" : ": " + help, values, numbers.empty() ? "" : numbers + "]", pitfall);
  }
  return out;
}

}  // namespace

std::string list_markdown(const std::string& what, std::span<const std::string_view> chosen) {
  Json all = as_json(list_called(what).rows(), {});
  for (Json& r : all) r.erase("reason"), r.erase("available");
  const std::vector<std::string> said = columns_of(all);
  if (chosen.empty()) return as_markdown(all, said);
  std::vector<std::string> columns;
  for (const std::string_view c : chosen)
    if (std::find(said.begin(), said.end(), c) == said.end())
      throw Error(ExitCode::bad_input, "list", fmt::format("'{}' has no column '{}'", what, c));
    else
      columns.emplace_back(c);
  return as_markdown(all, columns);
}

ExitCode run_list(const Arguments& a) {
  if (a.docs) {
    write_docs(*a.docs);
    return ExitCode::done;
  }
  if (a.manual) {
    write_manual(*a.manual);
    return ExitCode::done;
  }
  const List& list = list_called(a.what);
  if (a.markdown && !a.json) {
    fmt::print("{}", list_markdown(a.what));
    return ExitCode::done;
  }
  const Json all = as_json(list.rows(), availability(a));
  if (a.json)
    fmt::print("{}\n", all.dump(2));
  else
    fmt::print("{}", as_text(all));
  return ExitCode::done;
}

}  // namespace gbl
