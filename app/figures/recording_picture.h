#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <string>
#include <vector>

namespace halbench::app {

/// ".svg", ".pdf" or ".png": what a recording can be drawn as.
bool isPictureFile(const std::string& path);

struct PicturePanel {
    std::string unit;
    std::vector<std::size_t> columns;
    std::string rightUnit = {};
    std::vector<std::size_t> rightColumns = {}; ///< on the right axis
};

/// A panel for each unit, in the order of the columns. Those named are on the right axis of the panel of the
/// column before them. Errors: UnknownName, Usage (the first column; one axis for two units).
Result<std::vector<PicturePanel>> picturePanels(const StreamLayout& layout,
                                                const std::vector<std::string>& right = {});

/// The content of the picture file of that name: the recording, which has a row, over its time, for print.
/// Rows farther apart than neighbours and missing values interrupt the lines. Equal recordings give equal
/// pictures. Errors: of picturePanels(); Internal when nothing can be drawn here.
Result<std::string> recordingPicture(const Recording& recording, const std::string& title,
                                     const std::string& path, const std::vector<std::string>& right = {});

} // namespace halbench::app
