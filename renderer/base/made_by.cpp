#include "renderer/base/made_by.h"

#include <fmt/format.h>

#include "renderer/base/resources.h"

namespace gbl {

uint64_t fnv1a(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash;
}

std::string made_by() {
  std::string all;
  for (const std::string& name : resource_names("shaders/")) all += name + '\n' + resource(name);
  return fmt::format("{} {:016x}", GBL_VERSION, fnv1a(all));
}

}  // namespace gbl
