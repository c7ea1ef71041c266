#include "widgets/figure/picture_sheets.h"

#include "widgets/figure/figure_svg.h"

#include <QPainter>

#include <algorithm>

namespace halbench::widgets {
namespace {

constexpr int Gap_px = 6; ///< between two figures
constexpr int ColumnGap_px = 8;
constexpr int LeastColumn_px = 300; ///< axis and half as much again for the curves
constexpr int UsualColumn_px = PictureWidth_px / 2;

/// Where the sheets of a column are in the list.
struct SheetColumn {
    std::vector<std::size_t> sheets;
    double width_ratio = 1.0;
    int width_px = 0;
    int height_px = 0;
};

/// By column; all in one where they do not fit beside each other.
std::vector<SheetColumn> columnsOf(const std::vector<PictureSheet>& sheets, int width_px) {
    std::vector<SheetColumn> columns;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i == 0 || sheets[i].column != sheets[i - 1].column) {
            columns.emplace_back();
            columns.back().width_ratio = sheets[i].width_ratio;
        }
        columns.back().sheets.push_back(i);
    }
    const int count = static_cast<int>(columns.size());
    if (count * (LeastColumn_px + ColumnGap_px) - ColumnGap_px > width_px) {
        SheetColumn all;
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            all.sheets.push_back(i);
        }
        return {all};
    }
    return columns;
}

/// By their shares of what is left beyond what each needs, where one would get less than that.
void shareWidth(std::vector<SheetColumn>& columns, int width_px) {
    const int count = static_cast<int>(columns.size());
    const int room_px = width_px - (count - 1) * ColumnGap_px;
    double sum = 0.0;
    double least = columns.front().width_ratio;
    for (const SheetColumn& column : columns) {
        sum += column.width_ratio;
        least = std::min(least, column.width_ratio);
    }
    const bool isTooNarrow = room_px * least / sum < LeastColumn_px;
    const int own_px = isTooNarrow && count > 1 ? LeastColumn_px : 0;
    int left_px = room_px;
    for (SheetColumn& column : columns) {
        column.width_px = own_px + static_cast<int>((room_px - count * own_px) * column.width_ratio / sum);
        left_px -= column.width_px;
    }
    columns.back().width_px += left_px; // of rounding
}

/// What a title takes from the plots below it.
int titleRoom_px(const std::string& title) {
    Figure titled;
    titled.title = title;
    return layOut(titled, UsualColumn_px).size.height() - layOut(Figure(), UsualColumn_px).size.height();
}

FigureMargins widestOf(const std::vector<PictureSheet>& sheets, const SheetColumn& column) {
    FigureMargins widest;
    for (const std::size_t sheet : column.sheets) {
        const FigureMargins own = marginsOf(sheets[sheet].figure);
        widest.left_px = std::max(widest.left_px, own.left_px);
        widest.right_px = std::max(widest.right_px, own.right_px);
    }
    return widest;
}

std::vector<SheetColumn> placeSheets(const std::vector<PictureSheet>& sheets, int width_px,
                                     PictureLayout& layout) {
    std::vector<SheetColumn> columns = columnsOf(sheets, width_px);
    shareWidth(columns, width_px);
    int left_px = 0;
    for (SheetColumn& column : columns) {
        const FigureMargins widest = widestOf(sheets, column);
        int top_px = left_px > 0 ? titleRoom_px(sheets.front().figure.title) : 0;
        for (const std::size_t sheet : column.sheets) {
            layout.figures.push_back(layOut(sheets[sheet].figure, column.width_px, widest));
            layout.tops_px.push_back(top_px);
            layout.lefts_px.push_back(left_px);
            top_px += layout.figures.back().size.height() + Gap_px;
        }
        column.height_px = top_px - Gap_px;
        left_px += column.width_px + ColumnGap_px;
    }
    return columns;
}

int highest_px(const std::vector<SheetColumn>& columns) {
    int height_px = 0;
    for (const SheetColumn& column : columns) {
        height_px = std::max(height_px, column.height_px);
    }
    return height_px;
}

/// In proportion to what they have.
void addHeight(std::vector<PictureSheet>& sheets, const SheetColumn& column, int more_px) {
    int all_px = 0;
    for (const std::size_t sheet : column.sheets) {
        for (const Panel& panel : sheets[sheet].figure.panels) {
            all_px += panel.height_px;
        }
    }
    for (const std::size_t sheet : column.sheets) {
        for (Panel& panel : sheets[sheet].figure.panels) { // the last one gets what rounding left
            const int share_px = more_px * panel.height_px / all_px;
            all_px -= panel.height_px;
            more_px -= share_px;
            panel.height_px += share_px;
        }
    }
}

} // namespace

PictureLayout layOut(const std::vector<PictureSheet>& sheets, int width_px) {
    PictureLayout layout;
    layout.size = QSize(width_px, highest_px(placeSheets(sheets, width_px, layout)));
    return layout;
}

void levelColumns(std::vector<PictureSheet>& sheets, int width_px) {
    PictureLayout layout;
    const std::vector<SheetColumn> columns = placeSheets(sheets, width_px, layout);
    for (const SheetColumn& column : columns) {
        addHeight(sheets, column, highest_px(columns) - column.height_px);
    }
}

int widthForColumns(int columns) {
    return std::max(PictureWidth_px, columns * UsualColumn_px);
}

void paintSheets(QPainter& painter, const std::vector<PictureSheet>& sheets, const PictureLayout& layout,
                 const Theme& theme) {
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        painter.save();
        painter.translate(layout.lefts_px[i], layout.tops_px[i]);
        paintFigure(painter, sheets[i].figure, layout.figures[i], theme, QLatin1Char('.'), sheets[i].layers);
        painter.restore();
    }
}

namespace {

Result<Painting> paintingOf(const std::vector<PictureSheet>& sheets, int width_px) {
    if (sheets.empty()) {
        return failure(checkFigure({}).error());
    }
    for (const PictureSheet& sheet : sheets) {
        if (const Result<void> checked = checkFigure(sheet.figure); !checked) {
            return failure(checked.error());
        }
    }
    const PictureLayout layout = layOut(sheets, width_px);
    return Painting{sheets.front().figure.title, layout.size,
                    [&sheets, layout](QPainter& painter, const Theme& theme) {
                        paintSheets(painter, sheets, layout, theme);
                    }};
}

} // namespace

QImage sheetsImage(const std::vector<PictureSheet>& sheets, const Theme& theme, double fineness,
                   int width_px) {
    const Result<Painting> painting = paintingOf(sheets, width_px);
    return painting ? imageOf(*painting, theme, fineness) : QImage();
}

Result<QByteArray> sheetsFile(const std::vector<PictureSheet>& sheets, const Theme& theme,
                              PictureFormat format, int width_px) {
    const Result<Painting> painting = paintingOf(sheets, width_px);
    return painting ? fileOf(*painting, theme, format) : failure(painting.error());
}

} // namespace halbench::widgets
