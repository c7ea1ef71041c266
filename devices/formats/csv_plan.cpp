#include "devices/formats/csv_import.h"
#include "devices/formats/csv_text.h"

#include <QtCore/QTextCodec>

#include <fmt/format.h>

#include <cmath>

namespace halbench::devices {

namespace {

constexpr std::size_t ShownLines = 5;
constexpr std::size_t MaxColumns = 1024;

/// As it is when it is UTF-8, else as Latin-1: tables of older programs.
std::string inUtf8(std::string_view text) {
    QTextCodec::ConverterState state;
    const QTextCodec* codec = QTextCodec::codecForName("UTF-8");
    const QString decoded = codec->toUnicode(text.data(), static_cast<int>(text.size()), &state);
    const bool isUtf8 = state.invalidChars == 0 && state.remainingChars == 0;
    return (isUtf8 ? decoded : QString::fromLatin1(text.data(), static_cast<int>(text.size()))).toStdString();
}

std::string nameOf(std::string_view cell) {
    std::string name;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const bool isDoubledQuote = cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"';
        name += cell[i];
        i += isDoubledQuote ? 1 : 0;
    }
    return inUtf8(name);
}

std::vector<std::string> namesIn(std::string_view line, char separator) {
    std::vector<CsvCell> cells;
    splitCsv(line, separator, cells);
    std::vector<std::string> names;
    for (const CsvCell& cell : cells) {
        names.push_back(nameOf(cell.text));
    }
    return names;
}

struct HeaderLines {
    std::vector<std::string> names;
    std::vector<std::string> units;
    std::size_t width = 0;
};

std::size_t withoutEmptyEnd(const std::vector<std::string>& cells) {
    return cells.size() - (cells.size() > 1 && cells.back().empty() ? 1 : 0);
}

/// Without names, the width is that of the first row; an empty cell at the end of all first rows is only how
/// that program ends its lines.
HeaderLines readHeaderLines(std::string_view text, const CsvDialect& dialect) {
    CsvLines lines(text);
    CsvLine line;
    HeaderLines header;
    if (!lines.next(line)) {
        return header;
    }
    header.names = namesIn(line.text, dialect.separator);
    header.width = withoutEmptyEnd(header.names);
    if (dialect.header == CsvHeader::NamesAndUnits && lines.next(line)) {
        header.units = namesIn(line.text, dialect.separator);
    }
    if (dialect.header == CsvHeader::None) {
        bool endEmpty = header.width < header.names.size();
        for (std::size_t row = 1; row < DialectLines && endEmpty && lines.next(line); ++row) {
            const std::vector<std::string> cells = namesIn(line.text, dialect.separator);
            endEmpty = withoutEmptyEnd(cells) < cells.size();
        }
        header.width = header.names.size() - (endEmpty ? 1 : 0);
        header.names.clear();
    }
    return header;
}

Result<void> checkRate(const CsvImportRequest& request) {
    if (!request.rate_Hz) {
        return {};
    }
    if (!std::isfinite(*request.rate_Hz) || *request.rate_Hz < 1e-6 || *request.rate_Hz > 1e9) {
        return failure(ErrorCode::OutOfRange, "--rate_Hz: not between 1e-6 and 1e9",
                       "give the sampling rate in rows per second");
    }
    if (!request.timeColumn.empty()) {
        return failure(ErrorCode::Usage, "--time and --rate_Hz exclude each other", "give one of them");
    }
    return {};
}

} // namespace

Result<CsvPlan> planCsvImport(std::string_view text, const std::string& origin,
                              const CsvImportRequest& request) {
    if (const Result<void> rate = checkRate(request); !rate) {
        return failure(rate.error());
    }
    Result<CsvSight> sight = detectDialect(text, origin, request.hints);
    if (!sight) {
        return failure(sight.error());
    }
    CsvPlan plan;
    plan.sight = *std::move(sight);
    plan.questions = plan.sight.questions;
    plan.rate_Hz = request.rate_Hz;
    CsvLines lines(text);
    for (CsvLine line; plan.firstLines.size() < ShownLines && lines.next(line);) {
        plan.firstLines.push_back(inUtf8(line.text));
    }
    if (!plan.questions.empty()) {
        return plan;
    }
    plan.dialect = plan.sight.candidates.front();
    const HeaderLines header = readHeaderLines(text, *plan.dialect);
    if (header.width > MaxColumns) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: {} columns", origin, header.width),
                       fmt::format("at most {} are read", MaxColumns));
    }
    Result<CsvColumns> columns = arrangeColumns(header.names, header.units, header.width, request);
    if (!columns) {
        return failure(columns.error().code, origin + ": " + columns.error().message, columns.error().hint);
    }
    plan.columns = std::move(columns->columns);
    plan.time = columns->time;
    plan.questions = std::move(columns->questions);
    return plan;
}

} // namespace halbench::devices
