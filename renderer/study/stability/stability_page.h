#pragma once
// stability.html: the curves as a page on which every point explains itself.
#include "renderer/study/page/page.h"
#include "renderer/study/rows/study_row.h"
#include "renderer/study/stability/stability.h"

namespace gbl {

Page stability_page(const std::vector<SweepResult>&, const Machine&, const std::string& rounding_words);

}  // namespace gbl
