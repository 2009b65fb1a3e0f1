#include "renderer/gbuffer/layout_file.h"

#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/limits.h"
#include "renderer/base/resources.h"
#include "renderer/base/sha256.h"
#include "renderer/gbuffer/layout_header.h"

namespace gbl {
namespace {

constexpr size_t kHashDigits = 16;

// As settings name it, and with all that its row points to.
struct ReadLayout {
  std::string name, label, help, cost, no_roughness, shader;
  LayoutHeader header;
  LayoutRow row;
};

std::string hash_of(std::string_view text) { return sha256(text).substr(0, kHashDigits); }
std::string read_layout(const std::string& path) { return read_text_file(path, kMostShaderBytes); }

std::string file_name_of(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::unique_ptr<ReadLayout> make_layout(const std::string& name, const std::string& path, const std::string& text) {
  auto out = std::make_unique<ReadLayout>();
  out->header = parse_layout_header(text, path);
  out->name = name;
  out->label = file_name_of(path);
  out->help = fmt::format("the layout of {}", path);
  out->cost = fmt::format("{} B/px", out->header.bytes());
  out->shader = fmt::format("layout-file/{}", hash_of(text));
  out->row = out->header.row();
  out->row.axis = {
      .id = out->label.c_str(), .label = out->label.c_str(), .help = out->help.c_str(), .cost = out->cost.c_str()};
  if (!out->header.holds("roughness") && !out->header.holds("exponent")) {
    out->no_roughness = fmt::format("the layout {} stores no roughness", out->label);
    out->row.roughness_missing = out->no_roughness.c_str();
  }
  lend_resource("shaders/" + out->shader, text, path);
  return out;
}

const ReadLayout& layout_named(const std::string& name) {
  static std::map<std::string, std::unique_ptr<ReadLayout>> g_read;
  static std::mutex g_mutex;
  const std::lock_guard lock(g_mutex);
  std::unique_ptr<ReadLayout>& kept = g_read[name];
  if (kept) return *kept;
  const std::string path(path_of_layout_file(name)), text = read_layout(path);
  if (name != fmt::format("{}@{}", path, hash_of(text)))
    throw Error(ExitCode::bad_input, path, "is another layout than the one that these settings name: it was changed",
                fmt::format("give --layout-file {} to take it as it is now", path));
  kept = make_layout(name, path, text);
  return *kept;
}

// The paths that somebody asked for.
class Allowed {
 public:
  void add(std::string_view path) {
    const std::lock_guard lock(mutex_);
    paths_.insert(place_of(path));
  }
  void add_all() {
    const std::lock_guard lock(mutex_);
    all_ = true;
  }
  bool has(std::string_view path) {
    const std::lock_guard lock(mutex_);
    return all_ || paths_.contains(place_of(path));
  }

 private:
  // A session writes the whole path of what was typed as a short one.
  static std::filesystem::path place_of(std::string_view path) {
    std::error_code none;
    return std::filesystem::absolute(path, none).lexically_normal();
  }

  std::mutex mutex_;
  bool all_ = false;
  std::set<std::filesystem::path> paths_;
};

Allowed& allowed() {
  static Allowed g_allowed;
  return g_allowed;
}

}  // namespace

bool may_run_layout_file(std::string_view path_or_name) { return allowed().has(path_of_layout_file(path_or_name)); }

namespace {

const ReadLayout& asked_for(const std::string& name) {
  const std::string path(path_of_layout_file(name));
  if (!may_run_layout_file(path))
    throw Error(ExitCode::bad_input, path, "is shader text, named by a file and asked for by nobody: it is not run",
                fmt::format("look at it, then give --layout-file {}, or --run-layouts for all", path));
  return layout_named(name);
}

}  // namespace

void allow_every_layout_file() { allowed().add_all(); }
void allow_layout_file(std::string_view path_or_name) { allowed().add(path_of_layout_file(path_or_name)); }

std::string name_layout_file(const std::string& path) {
  allow_layout_file(path);
  return name_unasked_layout_file(path);
}

std::string name_unasked_layout_file(const std::string& path) {
  const std::string text = read_layout(path);
  std::string name = fmt::format("{}@{}", path, hash_of(text));
  layout_named(name);  // what is wrong with it is said now
  return name;
}

bool names_content(std::string_view name) {
  const size_t at = name.rfind('@');
  return at != std::string_view::npos && name.size() - at - 1 == kHashDigits &&
         name.find_first_not_of("0123456789abcdef", at + 1) == std::string_view::npos;
}

std::string_view path_of_layout_file(std::string_view name) {
  return names_content(name) ? name.substr(0, name.rfind('@')) : name;
}

const LayoutRow& layout_of_file(const std::string& name) { return asked_for(name).row; }
std::string shader_of_layout_file(const std::string& name) { return asked_for(name).shader; }

}  // namespace gbl
