#include "app/report/report_blocks.h"

#include "control/base/unit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using Cell = ReportTable::Cell;

constexpr const char* Missing = "\u2013";

Cell missingCell() {
    return {Missing, ReportTone::Muted};
}

Cell numberCell(std::optional<double> value) {
    return value && std::isfinite(*value) ? Cell{reportNumber(value), ReportTone::Plain} : missingCell();
}

Cell sourceCell(const std::string& source) {
    return {source, source == "not identifiable" ? ReportTone::Warn : ReportTone::Plain};
}

/// "1.2e-05" -> "1.2e-5": the exponent's padding is noise.
std::string tidyExponent(std::string text) {
    const std::size_t mark = text.find('e');
    if (mark != std::string::npos) {
        std::size_t digit = mark + 1;
        if (text[digit] == '+') {
            text.erase(digit, 1);
        } else if (text[digit] == '-') {
            ++digit;
        }
        while (digit + 1 < text.size() && text[digit] == '0') {
            text.erase(digit, 1);
        }
    }
    return text;
}

std::vector<Cell> estimateRow(const ReportEstimate& estimate) {
    Cell value = numberCell(estimate.value);
    Cell interval = missingCell();
    Cell relative = missingCell();
    if (estimate.value && estimate.ci95Low && estimate.ci95High) {
        const double half = 0.5 * (*estimate.ci95High - *estimate.ci95Low);
        value.text = reportNumber(*estimate.value, half);
        interval = {fmt::format("{} \u2026 {}", reportNumber(*estimate.ci95Low, half),
                                reportNumber(*estimate.ci95High, half))};
        // Beside a value near zero only the absolute half-width means something.
        const double share = half / std::abs(*estimate.value);
        relative = {share <= 1.0 ? fmt::format("\u00b1{:.2g} %", 100.0 * share)
                                 : fmt::format("\u00b1{}", tidyExponent(fmt::format("{:.2g}", half)))};
    }
    return {{estimate.name},     std::move(value),    {unitText(estimate.unit)},
            std::move(interval), std::move(relative), sourceCell(estimate.source)};
}

std::string limitText(const ReportCheck& check) {
    if (check.min && check.max) {
        return fmt::format("{} \u2026 {}", reportNumber(check.min), reportNumber(check.max));
    }
    if (check.min) {
        return "at least " + reportNumber(check.min);
    }
    return check.max ? "at most " + reportNumber(check.max) : std::string(Missing);
}

} // namespace

std::string reportNumber(std::optional<double> value) {
    return value && std::isfinite(*value) ? tidyExponent(fmt::format("{:.6g}", *value))
                                          : std::string(Missing);
}

std::string reportNumber(double value, double halfWidth) {
    if (!std::isfinite(value) || !std::isfinite(halfWidth) || halfWidth <= 0.0 || value == 0.0) {
        return reportNumber(value);
    }
    // Digits from the value's leading one down to the second of the half-width; trailing zeros are meant.
    const int leading = static_cast<int>(std::floor(std::log10(std::abs(value))));
    const int last = static_cast<int>(std::floor(std::log10(halfWidth))) - 1;
    const int digits = std::clamp(leading - last + 1, 2, 10);
    return tidyExponent(fmt::format("{:#.{}g}", value, digits));
}

ReportTable estimateTable(const std::string& caption, const std::vector<ReportEstimate>& estimates) {
    ReportTable table;
    table.caption = caption;
    table.columns = {{"quantity"},         {"value", true}, {"unit"}, {"95 % interval", true},
                     {"half-width", true}, {"source"}};
    for (const ReportEstimate& estimate : estimates) {
        table.rows.push_back(estimateRow(estimate));
    }
    return table;
}

ReportTable checkTable(const std::vector<ReportCheck>& checks) {
    ReportTable table;
    table.columns = {{"check"}, {"value", true}, {"unit"}, {"limit", true}, {"result"}};
    for (const ReportCheck& check : checks) {
        Cell value = numberCell(check.value);
        const Cell verdict = check.passed ? Cell{"\u2713 passed", ReportTone::Good}
                             : check.value && std::isfinite(*check.value)
                                 ? Cell{"\u2717 missed", ReportTone::Bad}
                                 : Cell{"\u2717 no value", ReportTone::Bad};
        table.rows.push_back(
            {{check.quantity}, std::move(value), {unitText(check.unit)}, {limitText(check)}, verdict});
    }
    return table;
}

ReportTable quantityTable(const std::string& caption, const std::vector<ReportQuantity>& quantities) {
    ReportTable table;
    table.caption = caption;
    table.columns = {{"name"}, {"value", true}, {"unit"}};
    for (const ReportQuantity& quantity : quantities) {
        table.rows.push_back(
            {{quantity.name}, numberCell(quantity.value), {unitText(quantity.unit), ReportTone::Muted}});
    }
    return table;
}

bool differs(const ReportChange& change) {
    constexpr double Rounding = 1e-6; // boards keep single precision
    return std::abs(change.after - change.before) >
           Rounding * std::max(std::abs(change.before), std::abs(change.after));
}

ReportTable changeTable(const std::string& caption, const std::vector<ReportChange>& changes) {
    ReportTable table;
    table.caption = caption;
    table.columns = {{"name"}, {"before", true}, {"after", true}, {"unit"}, {"change"}};
    for (const ReportChange& change : changes) {
        const bool isChanged = differs(change);
        table.rows.push_back(
            {{change.name},
             numberCell(change.before),
             numberCell(change.after),
             {unitText(change.unit), ReportTone::Muted},
             isChanged ? Cell{"changed", ReportTone::Plain} : Cell{"same", ReportTone::Muted}});
    }
    return table;
}

} // namespace halbench::app
