#pragma once
// Numbers as users type them: one rule for every option and every argument.
#include <optional>
#include <string_view>

namespace gbl {

// A decimal as JSON writes it: 12, -0.5, 1e-3. Empty for all else: "", ".5", "010", "0x10", "+1", "nan", " 1", "1 ",
// and what is beyond the range of double.
std::optional<double> decimal(std::string_view text);
std::optional<long long> whole_decimal(std::string_view text);  // without a point or an exponent

}  // namespace gbl
