#pragma once

#include "widgets/plot_marks.h"
#include "widgets/theme.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace halbench::widgets {

/// The cursors' times, which can be typed, their distance and its reciprocal.
class CursorBar : public QWidget {
    Q_OBJECT
public:
    explicit CursorBar(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setCursors(const CursorPair& cursors);
    /// "Δt 0.125 s   1/Δt 8 Hz"
    QString distanceText() const;

Q_SIGNALS:
    void cursorTyped(int index, double time_s);

private:
    QDoubleSpinBox* m_fields[2];
    QLabel* m_distance;
};

} // namespace halbench::widgets
