#include "renderer/light/light_methods.h"

#include "renderer/rows/value_table.h"

namespace gbl {
namespace {

#define METHOD(name, ...) {__VA_ARGS__},
constexpr LightMethodRow kMethods[] = {
#include "renderer/light/light_methods.inc"
};
#undef METHOD
constexpr auto kValues = values_of<kMethods>([](const LightMethodRow& r) { return r.axis; });

}  // namespace

GBL_ROWS(LightMethod, kValues)

const LightMethodRow& facts(LightMethod m) { return kMethods[static_cast<size_t>(m)]; }

}  // namespace gbl
