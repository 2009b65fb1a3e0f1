#pragma once
// The all-options panel: its pages, and the letter that selects an option on its page ("" = it has a key of its own).
#include "ui/state.h"

namespace gbl::ui {

int option_pages();
std::vector<const Option*> options_on_page(int page);
std::string option_letter(const std::vector<const Option*>& page, const Option&);

}  // namespace gbl::ui
