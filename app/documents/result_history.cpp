#include "app/documents/result_history.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"

#include <QtCore/QDir>
#include <QtCore/QFile>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr qint64 LargestDocument = qint64{16} << 20;

bool isIdentified(const control::Estimate& estimate) {
    return estimate.source == control::EstimateSource::Identified && estimate.value && estimate.interval95;
}

double halfWidth(const control::Estimate& estimate) {
    return (estimate.interval95->second - estimate.interval95->first) / 2.0;
}

bool isOfSameDevice(const ResultRow& one, const ResultRow& other) {
    return one.header.device && other.header.device && isSameDevice(*one.header.device, *other.header.device);
}

} // namespace

std::optional<ResultRow> resultOf(const std::string& file, const std::string& text) {
    const Result<JsonValue> root = parseDocument(text, file);
    if (!root || textIn(&*root, "schema") != "halbench.identification/1") {
        return std::nullopt;
    }
    ResultRow row{file, headerOf(*root), {}};
    const JsonValue* parameters = member(&*root, "parameters");
    for (std::size_t i = 0; i < HistoryParameters.size(); ++i) {
        row.values[i] = estimateOf(member(parameters, HistoryParameters[i]));
    }
    return row;
}

std::vector<ResultRow> resultsIn(const std::string& folder) {
    std::vector<ResultRow> rows;
    const QFileInfoList files = QDir(QString::fromStdString(folder))
                                    .entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    for (const QFileInfo& info : files) {
        QFile file(info.filePath());
        if (info.size() > LargestDocument || !file.open(QIODevice::ReadOnly)) {
            continue;
        }
        if (std::optional<ResultRow> row =
                resultOf(info.fileName().toStdString(), file.readAll().toStdString())) {
            rows.push_back(*std::move(row));
        }
    }
    std::stable_sort(rows.begin(), rows.end(), [](const auto& one, const auto& other) {
        return one.header.started < other.header.started;
    });
    return rows;
}

std::optional<Drift> driftOf(const control::Estimate& before, const control::Estimate& now) {
    if (!isIdentified(before) || !isIdentified(now) || *before.value == 0.0) {
        return std::nullopt;
    }
    const double change = *now.value - *before.value;
    return Drift{change / std::abs(*before.value),
                 std::abs(change) > std::hypot(halfWidth(before), halfWidth(now))};
}

std::optional<Drift> driftAt(const std::vector<ResultRow>& rows, std::size_t row, std::size_t parameter) {
    for (std::size_t first = 0; first < row; ++first) {
        if (isOfSameDevice(rows[first], rows[row]) && isIdentified(rows[first].values[parameter])) {
            return driftOf(rows[first].values[parameter], rows[row].values[parameter]);
        }
    }
    return std::nullopt;
}

} // namespace halbench::app
