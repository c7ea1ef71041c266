#pragma once

#include "widgets/actuators/htm/rotor_field_lines.h"
#include "widgets/theme/theme.h"

#include <QLineF>
#include <QPainterPath>
#include <QVector>
#include <QWidget>

#include <array>
#include <optional>

namespace halbench::widgets {

enum class FieldModel {
    Ideal,     ///< the two-dimensional cylinder
    Segmented, ///< its separate bars
    Measured   ///< the direction and size that the Hall sensors see
};

/// The rotor's cross-section, turning live: magnets with their magnetisation, field lines, the coils inked by
/// their current, the Hall sensors with what they read. Angles turn anticlockwise from sensor a, currents
/// are positive out of the page at the side that is 90 degrees ahead of the coil's axis. Lines are computed
/// once and turned: a frame is cheap. Source: resources/help/htm-theory.md sections 1, 3.1 and 4.
class RotorView : public QWidget {
    Q_OBJECT
public:
    explicit RotorView(QWidget* parent = nullptr);

    void setGeometryOf(const RotorGeometry& geometry);
    void setFieldModel(FieldModel model);
    FieldModel fieldModel() const { return m_model; }
    void setCurrentLimit_A(double limit_A);

    void setAngle(double angle_rad);
    void setCurrents(double current_a_A, double current_b_A);
    void setHall(double hall_a_T, double hall_b_T);
    void setStale(bool isStale); ///< the values are the last ones known
    void clear();                ///< nothing is known

    QSize sizeHint() const override { return {420, 420}; }
    QSize minimumSizeHint() const override { return {200, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Pair {
        double a = 0.0;
        double b = 0.0;
    };

    void cacheMagnets();
    const QVector<QLineF>& fieldPieces();
    double shownFieldAngle_rad() const;
    void drawMagnets(QPainter& painter, const Theme& theme) const;
    void drawArrows(QPainter& painter, const Theme& theme) const;
    void drawNames(QPainter& painter, const Theme& theme) const;
    void drawFieldLines(QPainter& painter, const Theme& theme);
    void drawCoils(QPainter& painter, const Theme& theme) const;
    void drawCoilSide(QPainter& painter, const Theme& theme, const QRectF& side, double current_A) const;
    void drawSensors(QPainter& painter, const Theme& theme) const;
    void drawAngleMark(QPainter& painter, const Theme& theme) const;
    void drawWords(QPainter& painter, const Theme& theme) const;
    void drawScale(QPainter& painter, const Theme& theme, double pixels_per_mm) const;
    QString modelName() const;
    void describe();

    RotorGeometry m_geometry;
    FieldModel m_model = FieldModel::Ideal;
    std::array<std::optional<QVector<QLineF>>, 3> m_pieces; ///< rotor frame, mm; by field model
    QPainterPath m_magnets;                                 ///< rotor frame, mm
    QVector<QLineF> m_magnetArrows;                         ///< rotor frame, mm
    double m_currentLimit_A = 4.0;
    std::optional<double> m_angle_rad;
    std::optional<Pair> m_current_A;
    std::optional<Pair> m_hall_T;
    bool m_isStale = false;
};

} // namespace halbench::widgets
