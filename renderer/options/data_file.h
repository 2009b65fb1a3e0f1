#pragma once
// What reading our data files (lessons, studies) has in common: every refusal names the file and the member.
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/json_fwd.h"

namespace gbl {

// "assets/lessons/" and "intro" -> "assets/lessons/intro.json"; and the ids of all that are there, sorted.
std::string data_file_name(std::string_view folder, std::string_view id);
std::vector<std::string> data_file_ids(std::string_view folder);

// Tables throw with a place of their own ("--preset: …"); in a file the file comes first.
template <class Look>
auto look_up(std::string_view where, Look look) {
  try {
    return look();
  } catch (const Error& e) {
    throw Error(e.code(), where, e.what());
  }
}

// A misspelt member would otherwise be silently without effect.
void only_members(const Json& node, std::initializer_list<std::string_view> known, std::string_view where);

std::string text_member(const Json& node, const char* member, std::string_view where);  // "" if it is not there
std::string needed_text_member(const Json& node, const char* member, std::string_view where);
// A place among others of its kind: a whole number from 1 to 9999; `otherwise` if it is not there.
int order_member(const Json& node, const char* member, int otherwise, std::string_view where);

// "version": a whole number from 1, none newer than `newest`. kind: "lesson"
void check_file_version(const Json&, int newest, std::string_view kind, std::string_view where);

}  // namespace gbl
