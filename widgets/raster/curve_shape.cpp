#include "widgets/raster/curve_shape.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

/// Up to so many samples a column the line through the samples is drawn.
constexpr double SparseSamples_ratio = 1.0;

void shapeLines(const control::TimeRange& drawn, const PixelMap& map, CurveShape& shape) {
    const auto newLine = [&shape] {
        if (shape.lineCount == 0 || !shape.lines[shape.lineCount - 1].empty()) {
            ++shape.lineCount;
            shape.lines.resize(std::max(shape.lines.size(), shape.lineCount));
        }
        shape.lines[shape.lineCount - 1].clear();
    };
    newLine();
    for (const control::TimedValue& sample : shape.samples) {
        if (sample.isAfterGap || std::isnan(sample.value)) {
            newLine();
        }
        const bool isAfterPause =
            sample.time_s > drawn.end_s && map.timeAt(map.columns) > drawn.end_s + 1.0 / map.perSecond;
        if (!std::isnan(sample.value) && !isAfterPause) {
            shape.lines[shape.lineCount - 1].push_back({map.x(sample.time_s), map.y(sample.value)});
        }
    }
}

/// Makes a box meet the one before half of the way.
void join(PixelBox& before, double ownTop, double ownBottom, PixelBox& box) {
    if (box.top > ownBottom) {
        const double middle = 0.5 * (ownBottom + box.top);
        before.bottom = std::max(before.bottom, middle);
        box.top = middle;
    } else if (box.bottom < ownTop) {
        const double middle = 0.5 * (box.bottom + ownTop);
        before.top = std::min(before.top, middle);
        box.bottom = middle;
    }
}

void shapeBoxes(const PixelMap& map, CurveShape& shape) {
    double ownTop = 0.0; // of the box before, as its samples have it
    double ownBottom = 0.0;
    for (std::size_t i = 0; i < shape.kept.columns.size(); ++i) {
        const control::HistoryColumn& column = shape.kept.columns[i];
        if (column.extremes.isEmpty()) {
            continue;
        }
        const double first = map.y(column.extremes.max);
        const double second = map.y(column.extremes.min);
        PixelBox box{static_cast<int>(i), std::min(first, second), std::max(first, second), false};
        const double top = box.top;
        const double bottom = box.bottom;
        if (!shape.boxes.empty() && !column.isAfterGap) {
            box.isJoined = true;
            if (shape.boxes.back().column + 1 == box.column) {
                join(shape.boxes.back(), ownTop, ownBottom, box);
            }
        }
        shape.boxes.push_back(box);
        ownTop = top;
        ownBottom = bottom;
    }
}

} // namespace

double PixelMap::y(double value) const {
    // Far outside is as good as outside, and safe to count with.
    return std::clamp(zero + perValue * value, -10.0 * rows - 100.0, 11.0 * rows + 100.0);
}

void shapeCurve(const control::SampleHistory& history, const std::string& signal, control::TimeRange drawn,
                const PixelMap& map, double dotDistance, CurveShape& shape) {
    shape.lineCount = 0;
    shape.boxes.clear();
    shape.areSamplesMarked = false;
    const control::TimeRange visible{std::max(drawn.begin_s, map.timeAt(0.0)),
                                     std::min(drawn.end_s, map.timeAt(map.columns))};
    if (visible.length_s() <= 0.0) {
        return;
    }
    const auto rows = static_cast<double>(history.rowsIn(signal, visible));
    const double width = visible.length_s() * map.perSecond;
    // Samples that the disk has not given yet are inside of the columns of their groups until it has.
    if (rows <= SparseSamples_ratio * width && history.samples(signal, visible, shape.samples)) {
        shapeLines(drawn, map, shape);
        shape.areSamplesMarked = rows * dotDistance < width;
    } else {
        const int count = std::clamp(
            static_cast<int>(std::ceil((visible.end_s - map.timeAt(0.0)) * map.perSecond)), 1, map.columns);
        history.columns(signal, {map.timeAt(0.0), map.timeAt(count)}, static_cast<std::size_t>(count),
                        shape.kept);
        shapeBoxes(map, shape);
    }
}

} // namespace halbench::widgets
