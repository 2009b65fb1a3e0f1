#include "renderer/study/page/html_text.h"

#include "renderer/base/base64.h"
#include "renderer/base/json.h"

namespace gbl {
namespace {

// By way of JSON, which knows what is UTF-8.
std::string valid_utf8(std::string_view text) {
  const std::string dumped = Json(std::string(text)).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(dumped).get<std::string>();
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : valid_utf8(text)) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      case '\n': out += "&#10;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
  return out;
}

// Only a "<" could end the element or begin a comment in it. In JSON it stands in texts alone.
std::string json_for_script(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

std::string data_url(std::string_view type, std::string_view bytes) {
  return std::string("data:").append(type).append(";base64,").append(base64(bytes));
}

}  // namespace gbl
