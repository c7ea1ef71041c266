#pragma once

#include "widgets/raster/curve_shape.h"

#include <QColor>
#include <QImage>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace halbench::widgets {

/// Draws one curve into an image with antialiasing: how much of each pixel the line covers is summed column
/// by column, then blended once. Costs the pixels under the line, whatever its width.
class CurveMask {
public:
    void begin(int columns, int rows);
    /// What a round pen of the given width leaves when it goes up and down a column between two rows.
    void addBox(int column, double top, double bottom, double width);
    /// A straight line of the given width.
    void addLine(PixelPoint from, PixelPoint to, double width);
    void addDot(PixelPoint centre, double diameter);
    /// Blends what was added into an RGB32 image; columns without ink are left out (dashes).
    void paint(QImage& image, const QColor& colour, const std::function<bool(int)>& isInk) const;

private:
    struct Rows {
        int first = 0;
        int end = 0; ///< nothing touched while not after `first`
    };
    /// What a pen covers of a column so many columns away, and how far it reaches up and down there.
    struct PenColumn {
        double covered = 0.0;
        double beyond = 0.0;
    };
    const std::uint8_t* pixelsOf(int column) const;
    std::uint8_t* pixelsOf(int column);
    void touch(int column, int first, int end);
    void add(int column, int row, double coverage);
    void setPen(double width);
    void raise(int column, double top, double bottom, double covered);
    void addFlatLine(PixelPoint from, PixelPoint to, double halfHeight);
    void addSteepLine(PixelPoint from, PixelPoint to, double halfWidth);

    int m_columns = 0;
    int m_rows = 0;
    double m_penWidth = 0.0;
    std::vector<PenColumn> m_pen;         ///< from its middle outwards
    std::vector<std::uint8_t> m_coverage; ///< column by column
    std::vector<Rows> m_touched;
};

} // namespace halbench::widgets
