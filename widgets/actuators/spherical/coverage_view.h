#pragma once

#include "widgets/theme/theme.h"

#include <QPointF>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace halbench::widgets {

/// Evenly spaced angles of one axis of a slice, in degrees.
struct SliceAxis {
    QString name; ///< "α"
    double first_deg = -45.0;
    double step_deg = 1.0;
    int count = 1;

    double at(int index) const { return first_deg + index * step_deg; }
    double last_deg() const { return at(count - 1); }
};

/// A quantity over two of the three angles of a pose, the third held.
struct CoverageSlice {
    SliceAxis x;
    SliceAxis y;
    QString quantity;
    QString unit;
    int decimals = 2;
    std::vector<double> values;    ///< row by row, y outside; not finite: none
    std::vector<bool> isUncovered; ///< as long as values
    double low = 0.0;              ///< ends of the colours
    double high = 1.0;
    std::optional<QPointF> marked; ///< a pose that is named, x and y in degrees

    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(x.count) +
               static_cast<std::size_t>(column);
    }
};

/// A slice as a map of colours. Uncovered poses have the colour of an error, a named pose a cross. A click or
/// the arrow keys choose a pose, whose value is read out; Page Up and Page Down make ten steps, Home goes to
/// the middle.
class CoverageView : public QWidget {
    Q_OBJECT
public:
    explicit CoverageView(QWidget* parent = nullptr);

    void setSlice(CoverageSlice slice);
    const CoverageSlice& slice() const { return m_slice; }
    /// "α 3°, β −2°: 12.34 mT, not covered"; empty without a slice.
    QString cursorText() const;
    /// The chosen pose, x and y in degrees.
    std::optional<QPointF> cursor() const;
    /// Paints the picture into a rectangle of this size, also for files.
    void draw(QPainter& painter, const Theme& theme, const QSizeF& size) const;

    QSize sizeHint() const override { return {420, 360}; }
    QSize minimumSizeHint() const override { return {220, 180}; }

Q_SIGNALS:
    void cursorMoved();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRectF mapOf(const QSizeF& size, const QFontMetricsF& metrics) const;
    QPointF placeOf(const QRectF& map, double x_deg, double y_deg) const;
    void drawMap(QPainter& painter, const Theme& theme, const QRectF& map) const;
    void drawAxes(QPainter& painter, const Theme& theme, const QRectF& map) const;
    void drawColours(QPainter& painter, const Theme& theme, const QRectF& map) const;
    void drawMarks(QPainter& painter, const Theme& theme, const QRectF& map) const;
    void moveCursor(int column, int row);
    void describe();

    CoverageSlice m_slice;
    int m_column = -1; ///< of the cursor; negative: none
    int m_row = -1;
};

} // namespace halbench::widgets
