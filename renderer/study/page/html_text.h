#pragma once
// Texts as parts of an HTML page: whatever stands in them, they stay texts.
#include <string>
#include <string_view>

#include "renderer/base/json_fwd.h"

namespace gbl {

// For an element's content and for an attribute in double quotes. What is not UTF-8 and what no page may hold is replaced.
std::string html_text(std::string_view);
// For the content of a script element of type application/json: nothing in it ends the element.
std::string json_for_script(const Json&);
std::string data_url(std::string_view type, std::string_view bytes);  // "data:image/jpeg;base64,…"

}  // namespace gbl
