#include "renderer/pitfalls/pitfalls.h"

#include <cstddef>

#include "renderer/base/kebab.h"

namespace gbl {
namespace {

constexpr const char* kIds[] = {
    "",
#define PITFALL(name, ...) kKebab<Kebab{#name}>,
#define MISTAKE PITFALL
#include "renderer/pitfalls/mistakes.inc"
#include "renderer/pitfalls/pitfalls.inc"
#undef MISTAKE
#undef PITFALL
};

}  // namespace

const char* id_of(Pitfall p) { return kIds[static_cast<size_t>(p)]; }

}  // namespace gbl
