#pragma once

#include "app/procedures/base/procedure.h"
#include "control/base/result.h"
#include "widgets/figure/figure.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halbench::app {

/// Contents of a report as plain values, filled from the results of procedures. All texts are UTF-8 without
/// markup.

/// Meaning of a word or cell; shown by colour and always by its words too.
enum class ReportTone { Plain, Good, Warn, Bad, Muted };

struct ReportParagraph {
    std::string text;
    ReportTone tone = ReportTone::Plain;
};

/// Label and value pairs: device, firmware, seed, margins ...
struct ReportFacts {
    struct Fact {
        std::string label;
        std::string value;
        ReportTone tone = ReportTone::Plain;
    };
    std::vector<Fact> facts;

    /// Adds nothing when the figure was not measured.
    void addMeasured(std::string label, const std::optional<double>& value, int decimals, const char* unit);
};

struct ReportTable {
    struct Column {
        std::string title;
        bool isNumeric = false; ///< right-aligned with tabular digits
    };
    struct Cell {
        std::string text;
        ReportTone tone = ReportTone::Plain;
    };
    std::string caption;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
};

/// The verdict on a result with its findings in words.
struct ReportQuality {
    DataQuality quality;
};

struct ReportPlot {
    widgets::Figure figure;
    std::string caption;
};

using ReportBlock = std::variant<ReportParagraph, ReportFacts, ReportTable, ReportQuality, ReportPlot>;

struct ReportSection {
    std::string heading;
    std::vector<ReportBlock> blocks;
};

struct ReportContent {
    std::string title;
    std::string summary; ///< one or two sentences under the title
    std::string device;  ///< e.g. "htm, sim:htm?seed=1"
    std::string started; ///< ISO 8601 as in result.json; never read from a clock here
    bool isSimulated = false;
    std::optional<bool> passed; ///< all checks; without checks there is no such badge
    std::vector<ReportSection> sections;
};

/// The report as one self-contained HTML document: inline SVG and CSS, no scripts, no links to anything.
/// Equal content gives equal bytes in every locale, with and without a display.
///
/// Plots need a QApplication. When none exists one is created on Qt's offscreen platform and lives until this
/// function returns; so a headless program must not hold a plain QCoreApplication while it draws. Main thread
/// only. Errors: InvalidInput when a figure's curve has different numbers of x and y; Internal when a plain
/// QCoreApplication is in the way.
Result<std::string> renderReport(const ReportContent& content);

} // namespace halbench::app
