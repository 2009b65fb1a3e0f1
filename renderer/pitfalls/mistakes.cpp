#include "renderer/pitfalls/mistakes.h"

#include <fmt/format.h>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/kebab.h"

namespace gbl {
namespace {

#define MISTAKE(name, ...) {Mistake::name, kKebab<Kebab{#name}>, __VA_ARGS__},
constexpr MistakeRow kMistakes[] = {
#include "renderer/pitfalls/mistakes.inc"
};
#undef MISTAKE

}  // namespace

std::span<const MistakeRow> mistakes() { return kMistakes; }

const MistakeRow& row(Mistake m) { return kMistakes[static_cast<size_t>(m)]; }

Mistake mistake_by_id(std::string_view id) {
  std::vector<std::string_view> known;
  for (const MistakeRow& m : kMistakes) {
    if (m.id == id) return m.mistake;
    known.emplace_back(m.id);
  }
  throw Error(ExitCode::bad_input, "mistakes", fmt::format("unknown mistake '{}'", id), suggest(id, known));
}

}  // namespace gbl
