#include "renderer/base/resources.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <sstream>

#include "renderer/base/error.h"

// Each file's bytes go into the program as they are: the assembler copies them, which is instant for a font and
// needs no generated source. The rows are written by CMake: ROW("shaders/combine.frag", "<file>").
#if defined(__APPLE__)
#define GBL_SECTION ".const_data\n"
#define GBL_SYMBOL(n) "_gbl_resource_" #n
#elif defined(__wasm__)
#define GBL_SECTION ".section .rodata.gbl_resources,\"\",@\n"
#define GBL_SYMBOL(n) "gbl_resource_" #n
#else
#define GBL_SECTION ".section .rodata\n"
#define GBL_SYMBOL(n) "gbl_resource_" #n
#endif
// WebAssembly wants each symbol's kind and size.
#ifdef __wasm__
#define GBL_KIND(symbol) ".type " symbol ",@object\n"
#define GBL_SIZE(symbol, size) ".size " symbol ", " size "\n"
#else
#define GBL_KIND(symbol)
#define GBL_SIZE(symbol, size)
#endif
#define GBL_LABEL(symbol) ".globl " symbol "\n" GBL_KIND(symbol) symbol ":\n"
// clang-format off
#define EMBED_AT(line, file)                                                                   \
  asm(GBL_SECTION GBL_LABEL(GBL_SYMBOL(line)) ".incbin \"" file "\"\n"                         \
      GBL_LABEL(GBL_SYMBOL(line##_end)) ".ascii \"\\0\"\n"                                     \
      GBL_SIZE(GBL_SYMBOL(line), GBL_SYMBOL(line##_end) "-" GBL_SYMBOL(line))                  \
      GBL_SIZE(GBL_SYMBOL(line##_end), "1") ".text\n");                                        \
  extern "C" const char gbl_resource_##line[];                                                 \
  extern "C" const char gbl_resource_##line##_end[];
// clang-format on
#define EMBED(line, file) EMBED_AT(line, file)
#define ROW(name, file) EMBED(__LINE__, file)
#include "resource_rows.inc"
#undef ROW

namespace gbl {
namespace {

struct Embedded {
  std::string_view name;
  const char* begin;
  const char* end;
};
#define FOUND_AT(line, name) {name, gbl_resource_##line, gbl_resource_##line##_end},
#define FOUND(line, name) FOUND_AT(line, name)
#define ROW(name, file) FOUND(__LINE__, name)
const Embedded kEmbedded[] = {
#include "resource_rows.inc"
};
#undef ROW

std::filesystem::path g_override =
    std::filesystem::exists(std::filesystem::path(GBL_SOURCE_FOLDER) / "shaders") ? GBL_SOURCE_FOLDER : "";

struct Lent {
  std::string text, shown;
};
std::map<std::string, Lent, std::less<>> g_lent;
std::mutex g_lent_mutex;

std::optional<Lent> lent(std::string_view name) {
  const std::lock_guard lock(g_lent_mutex);
  const auto found = g_lent.find(name);
  return found == g_lent.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::string_view embedded_bytes(std::string_view name) {
  for (const Embedded& e : kEmbedded)
    if (e.name == name) return {e.begin, static_cast<size_t>(e.end - e.begin)};
  throw Error(ExitCode::bad_input, name, "no such resource");
}

void lend_resource(const std::string& name, std::string text, std::string shown) {
  const std::lock_guard lock(g_lent_mutex);
  g_lent[name] = {std::move(text), std::move(shown)};
}

std::string shown_name(const std::string& name) {
  const std::optional<Lent> found = lent(name);
  return found ? found->shown : name;
}

std::string resource(std::string_view name) {
  if (std::optional<Lent> found = lent(name)) return std::move(found->text);
  if (!g_override.empty()) {
    std::ifstream file(g_override / name, std::ios::binary);
    std::stringstream text;
    if (file && text << file.rdbuf()) return text.str();
  }
  return std::string(embedded_bytes(name));
}

std::vector<std::string> resource_names(std::string_view prefix) {
  std::vector<std::string> names;
  for (const Embedded& e : kEmbedded)
    if (e.name.starts_with(prefix)) names.emplace_back(e.name);
  std::sort(names.begin(), names.end());
  return names;
}

void set_override_folder(std::filesystem::path folder) { g_override = std::move(folder); }
std::filesystem::path override_folder() { return g_override; }

long long shaders_stamp() {
  if (g_override.empty()) return 0;
  constexpr long long kNone = std::numeric_limits<long long>::min();
  long long newest = kNone;  // not 0: some libraries count file times from the year 2174, so that all are negative
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(g_override / "shaders", ignored)) {
    const auto time = entry.last_write_time(ignored);
    if (!ignored) newest = std::max<long long>(newest, time.time_since_epoch().count());
  }
  return newest == kNone ? 0 : newest;
}

}  // namespace gbl
