#pragma once
// study.html: a study's rows as a page on which every dot explains itself.
#include <filesystem>
#include <functional>

#include "renderer/study/page/page.h"
#include "renderer/study/study_spec.h"

namespace gbl {

// The command line that measures these settings again.
using CommandFn = std::function<std::string(const Settings&)>;

// Thumbnails are read from `folder`, where the study has written them.
Page study_page(const StudySpec&, const std::vector<StudyRow>& rows, const Machine&, const CommandFn&,
                const std::filesystem::path& folder);

}  // namespace gbl
