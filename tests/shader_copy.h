#pragma once
// Shaders that a test may break.
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include "renderer/base/files.h"
#include "renderer/base/resources.h"
#include "renderer/picture/image.h"
#include "tests/test_paths.h"

namespace gbl::test {

// A copy of the shaders that may be broken; the real ones are back when it dies.
class ShaderCopy {
 public:
  ShaderCopy() : before_(override_folder()), folder_(build_folder() / fmt::format("shader_copy_{}", getpid())) {
    for (const std::string& name : resource_names("shaders/")) {
      make_folder((folder_ / name).parent_path());
      write_text_file(folder_ / name, resource(name));
    }
    set_override_folder(folder_);
  }
  ~ShaderCopy() {
    set_override_folder(before_);
    std::filesystem::remove_all(folder_);
  }
  // Puts a line of its own before the first line that holds `mark`; -> its number. A mark that the shader no longer
  // holds is an exception, which fails the test: the line would break another place than the one that is guarded.
  int insert(const char* name, const std::string& mark, const std::string& line) {
    const std::string text = resource(name);
    const size_t found = text.find(mark);
    if (found == std::string::npos) throw std::invalid_argument(fmt::format("{} does not hold '{}'", name, mark));
    const size_t at = text.rfind('\n', found) + 1;
    write_text_file(folder_ / name, text.substr(0, at) + line + "\n" + text.substr(at));
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
  }
  // Puts a text in the place of another that stands there once.
  void replace(const char* name, const std::string& old, const std::string& by) {
    std::string text(resource(name));
    const size_t at = text.find(old);
    if (at == std::string::npos || text.find(old, at + 1) != std::string::npos)
      throw std::invalid_argument(fmt::format("{} does not hold '{}' once", name, old));
    write_text_file(folder_ / name, text.replace(at, old.size(), by));
  }
  void restore(const char* name) { write_text_file(folder_ / name, std::string(embedded_bytes(name))); }

 private:
  std::filesystem::path before_, folder_;
};

}  // namespace gbl::test
