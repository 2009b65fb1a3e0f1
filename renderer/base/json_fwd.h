#pragma once
// The name alone, for headers that hand JSON on; who reads or writes it includes renderer/base/json.h.
#include <nlohmann/json_fwd.hpp>

namespace gbl {
using Json = nlohmann::ordered_json;  // keeps the tables' order in files
}
