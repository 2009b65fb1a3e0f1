#include "app/format_keeper.h"

#include <fmt/format.h>

#include "app/state_folder.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

// An object of device -> names that held. Whatever else it holds is as if it were not there.
Json read_held(const fs::path& file) {
  try {
    if (!file.empty() && fs::exists(file)) {
      Json json = parse_json(read_text_file(file), file.string());
      if (json.is_object()) return json;
    }
  } catch (const Error&) {
  }
  return Json::object();
}

}  // namespace

fs::path format_file() {
  const std::optional<fs::path> folder = state_folder();
  return folder ? *folder / "format-checks.json" : fs::path();
}

FormatKeeper::FormatKeeper(fs::path file, const gl::Device& d)
    : file_(std::move(file)), device_(fmt::format("{}, {}, {}", d.renderer, d.version, made_by())) {
  const Json json = read_held(file_);
  if (!json.contains(device_) || !json[device_].is_array()) return;
  for (const Json& name : json[device_])
    if (name.is_string()) held_.insert(name.get<std::string>());
}

void FormatKeeper::keep() const {
  if (file_.empty()) return;
  try {
    Json json = read_held(file_);  // another process may have written meanwhile
    json[device_] = held_;
    make_private_folder(file_.parent_path());
    write_text_file(file_, json.dump(2) + "\n");
  } catch (const Error&) {
  }
}

void FormatKeeper::check(const Settings& resolved) {
  bool more_held = false;
  for (const StoredAs s : stored_by(resolved)) {
    const std::string name = name_of(s);
    if (held_.count(name) || failed_.count(name)) continue;
    const FormatCheck c = check_format(s, gl::probe_rounding());
    (c.holds() ? held_ : failed_).insert(name);
    more_held |= c.holds();
    if (c.holds()) continue;
    doubts_.push_back(c.said());
    fmt::print(stderr, "gbufferlab: this device, with these shaders: {}; numbers may be wrong\n", doubts_.back());
  }
  if (more_held) keep();
}

}  // namespace gbl
