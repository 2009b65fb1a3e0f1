#pragma once
// Members of a figure's JSON, each checked.
#include <glm/glm.hpp>
#include <string_view>

#include "renderer/base/json_fwd.h"

namespace gbl {

bool flag_member(const Json&, const char* member, bool otherwise, std::string_view where);
double number_member(const Json&, const char* member, double otherwise, double least, double most,
                     std::string_view where);
int whole_member(const Json&, const char* member, int otherwise, int least, int most, std::string_view where);
// Two numbers from 0 to 1: a place on a picture.
glm::dvec2 place_member(const Json&, const char* member, glm::dvec2 otherwise, std::string_view where);

}  // namespace gbl
