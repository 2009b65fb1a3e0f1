#pragma once
// JSON: only where a file or an answer is read or written. In between, values are typed.
#include <nlohmann/json.hpp>

#include "renderer/base/json_fwd.h"
