// What a rotor view paints.
#include "control/base/units.h"
#include "widgets/actuators/htm/rotor_view.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double MmPerM = 1e3;
constexpr double Margin_mm = 2.5;        ///< around the housing
constexpr double ArrowFullScale_T = 0.2; ///< a Hall arrow this long reaches the bore
constexpr double ScaleArrow_T = 0.1;
constexpr double CoilName_mm = 4.0;
constexpr double SensorName_mm = 2.1;
constexpr int LeastName_px = 9;
constexpr int Lines = 22;

QPointF mm(const Eigen::Vector2d& point_m) {
    return {point_m.x() * MmPerM, point_m.y() * MmPerM};
}

/// Single pieces: the raster engine draws them many times faster than one long path of wide lines.
QVector<QLineF> piecesOf(const std::vector<FieldLine>& lines) {
    QVector<QLineF> pieces;
    for (const FieldLine& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            pieces.append(QLineF(mm(line[i - 1]), mm(line[i])));
        }
    }
    return pieces;
}

/// An arrow along +x of this length, its middle at the origin.
QVector<QLineF> arrowOf(double length_mm, double head_mm) {
    const double half = length_mm / 2.0;
    return {QLineF(-half, 0.0, half, 0.0), QLineF(half - head_mm, head_mm * 0.7, half, 0.0),
            QLineF(half - head_mm, -head_mm * 0.7, half, 0.0)};
}

/// A line of this many logical pixels whatever the scale of the picture.
QPen linePen(const QPainter& painter, const QColor& colour, double width_px) {
    QPen pen(colour, width_px * painter.device()->devicePixelRatioF(), Qt::SolidLine, Qt::SquareCap,
             Qt::MiterJoin); // round ends would take the slow way
    pen.setCosmetic(true);
    return pen;
}

QString fixed(double value, int decimals) {
    return fixedText(value, decimals);
}

} // namespace

void RotorView::cacheMagnets() {
    m_magnets = {};
    m_magnetArrows = {};
    const double side_mm = 2.0 * m_geometry.ring.halfSize_m.x() * MmPerM;
    const QVector<QLineF> arrow = arrowOf(0.68 * side_mm, 0.25 * side_mm);
    for (const models::CuboidMagnet& magnet : models::ringMagnets(m_geometry.ring, 0.0)) {
        QTransform place;
        const QPointF centre = mm(magnet.centre_m.head<2>());
        place.translate(centre.x(), centre.y());
        place.rotate(radiansToDegrees(magnet.angle_rad));
        const QPointF half(magnet.halfSize_m.x() * MmPerM, magnet.halfSize_m.y() * MmPerM);
        m_magnets.addPolygon(place.map(QPolygonF(QRectF(-half, half))));
        for (const QLineF& line : arrow) {
            m_magnetArrows.append(place.map(line));
        }
    }
}

const QVector<QLineF>& RotorView::fieldPieces() {
    auto& pieces = m_pieces[static_cast<std::size_t>(m_model)];
    if (!pieces) {
        switch (m_model) {
        case FieldModel::Ideal:
            pieces = piecesOf(idealFieldLines(m_geometry, Lines));
            break;
        case FieldModel::Segmented:
            pieces = piecesOf(segmentedFieldLines(m_geometry, Lines));
            break;
        case FieldModel::Measured:
            pieces = piecesOf(uniformFieldLines(m_geometry, Lines));
            break;
        }
    }
    return *pieces;
}

double RotorView::shownFieldAngle_rad() const {
    if (m_model == FieldModel::Measured) {
        return m_hall_T ? std::atan2(m_hall_T->b, m_hall_T->a) : 0.0;
    }
    return m_angle_rad.value_or(0.0);
}

void RotorView::paintEvent(QPaintEvent*) {
    const Theme theme = currentTheme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.plotBackground);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    const double radius_mm = m_geometry.housingRadius_m * MmPerM + Margin_mm;
    const double scale = std::min(width(), height()) / (2.0 * radius_mm);
    painter.translate(width() / 2.0, height() / 2.0);
    painter.scale(scale, -scale); // y upward, millimetres
    drawMagnets(painter, theme);
    drawFieldLines(painter, theme);
    drawArrows(painter, theme);
    drawCoils(painter, theme);
    drawSensors(painter, theme);
    drawAngleMark(painter, theme);
    drawNames(painter, theme);
    painter.restore();
    drawWords(painter, theme);
    drawScale(painter, theme, scale);
}

void RotorView::drawMagnets(QPainter& painter, const Theme& theme) const {
    const double housing_mm = m_geometry.housingRadius_m * MmPerM;
    const double bore_mm = m_geometry.boreRadius_m() * MmPerM;
    QPainterPath ring;
    ring.addEllipse(QPointF(), housing_mm, housing_mm);
    ring.addEllipse(QPointF(), bore_mm, bore_mm);
    painter.setPen(linePen(painter, theme.line, 1.0));
    painter.setBrush(theme.raised);
    painter.drawPath(ring);
    painter.setBrush(mixed(theme.raised, theme.muted, 0.3));
    painter.setPen(Qt::NoPen);
    painter.save();
    painter.rotate(radiansToDegrees(m_angle_rad.value_or(0.0)));
    painter.drawPath(m_magnets);
    painter.restore();
}

void RotorView::drawArrows(QPainter& painter, const Theme& theme) const {
    QPen pen = linePen(painter, theme.text, 1.5);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.save();
    painter.rotate(radiansToDegrees(m_angle_rad.value_or(0.0)));
    painter.drawLines(m_magnetArrows);
    painter.restore();
}

void RotorView::drawFieldLines(QPainter& painter, const Theme& theme) {
    const bool isKnown = m_model == FieldModel::Measured ? m_hall_T.has_value() : m_angle_rad.has_value();
    if (!isKnown) {
        return;
    }
    QPen pen = linePen(painter, m_isStale ? theme.muted : theme.curves[2], 1.0);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.save();
    painter.rotate(radiansToDegrees(shownFieldAngle_rad()));
    painter.drawLines(fieldPieces());
    pen.setWidthF(2.0 * painter.device()->devicePixelRatioF());
    painter.setPen(pen);
    const double bore_mm = m_geometry.boreRadius_m() * MmPerM;
    painter.drawLines(arrowOf(0.26 * bore_mm, 0.07 * bore_mm)); // which way the lines run
    painter.restore();
}

void RotorView::drawCoils(QPainter& painter, const Theme& theme) const {
    const models::RadialCoil& coil = m_geometry.coil;
    const double radial_mm = coil.windowRadial_m * MmPerM;
    const double tangential_mm = coil.windowTangential_m * MmPerM;
    const double radius_mm = coil.meanRadius_m * MmPerM;
    const double offset_mm = coil.meanWidth_m / 2.0 * MmPerM;
    const Pair current_A = m_current_A.value_or(Pair{});
    for (int quarter = 0; quarter < 4; ++quarter) {
        // Opposite coils are in series: both axes point along that of the phase, so the upper side of the
        // one is the lower side of the other.
        const double phase_A = quarter % 2 == 0 ? current_A.a : current_A.b;
        const double sign = quarter < 2 ? 1.0 : -1.0;
        painter.save();
        painter.rotate(90.0 * quarter);
        for (const double side : {1.0, -1.0}) {
            const QPointF centre(radius_mm, side * offset_mm);
            QRectF box(0.0, 0.0, radial_mm, tangential_mm);
            box.moveCenter(centre);
            drawCoilSide(painter, theme, box, sign * side * phase_A);
        }
        painter.restore();
    }
}

void RotorView::drawCoilSide(QPainter& painter, const Theme& theme, const QRectF& side,
                             double current_A) const {
    const double share = std::clamp(std::abs(current_A) / m_currentLimit_A, 0.0, 1.0);
    const QColor& full = current_A >= 0.0 ? theme.curves[1] : theme.curves[0];
    QPen pen = linePen(painter, mixed(theme.muted, full, share), 1.0);
    painter.setPen(pen);
    painter.setBrush(mixed(theme.panel, m_isStale ? theme.muted : full, 0.85 * share));
    painter.drawRect(side);
    if (!m_current_A || share < 0.005) {
        return;
    }
    // A dot comes out of the page, a cross goes in.
    const double r = 0.3 * std::min(side.width(), side.height());
    const QPointF c = side.center();
    pen.setColor(theme.text);
    pen.setWidthF(1.25 * painter.device()->devicePixelRatioF());
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(c, r, r);
    if (current_A > 0.0) {
        painter.setBrush(theme.text);
        painter.drawEllipse(c, r / 4.0, r / 4.0);
    } else {
        const double d = r * std::sqrt(0.5);
        painter.drawLine(c + QPointF(-d, -d), c + QPointF(d, d));
        painter.drawLine(c + QPointF(-d, d), c + QPointF(d, -d));
    }
}

void RotorView::drawSensors(QPainter& painter, const Theme& theme) const {
    const double radius_mm = m_geometry.sensorRadius_m * MmPerM;
    const double reach_mm = m_geometry.boreRadius_m() * MmPerM - radius_mm;
    const Pair hall_T = m_hall_T.value_or(Pair{});
    for (int sensor = 0; sensor < 2; ++sensor) {
        const QColor ink = m_isStale ? theme.muted : theme.curves[sensor == 0 ? 3 : 5];
        QPen pen = linePen(painter, ink, 1.5);
        painter.save();
        painter.rotate(90.0 * sensor);
        painter.setPen(pen);
        painter.setBrush(theme.panel);
        painter.drawRect(QRectF(radius_mm - 1.4, -1.4, 2.8, 2.8));
        if (m_hall_T) {
            const double field_T = sensor == 0 ? hall_T.a : hall_T.b;
            const double length_mm = reach_mm * std::clamp(field_T / ArrowFullScale_T, -1.0, 1.0);
            pen.setWidthF(3.0 * painter.device()->devicePixelRatioF());
            painter.setPen(pen);
            painter.setBrush(Qt::NoBrush);
            painter.translate(radius_mm + length_mm / 2.0, 0.0);
            painter.rotate(length_mm < 0.0 ? 180.0 : 0.0);
            const double length = std::abs(length_mm);
            painter.drawLines(arrowOf(length, std::min(2.2, 0.6 * length)));
        }
        painter.restore();
    }
}

void RotorView::drawAngleMark(QPainter& painter, const Theme& theme) const {
    const double rim_mm = m_geometry.housingRadius_m * MmPerM;
    QPen pen = linePen(painter, theme.muted, 1.0);
    painter.setPen(pen);
    for (int quarter = 0; quarter < 4; ++quarter) { // of the stator
        painter.save();
        painter.rotate(90.0 * quarter);
        painter.drawLine(QPointF(rim_mm, 0.0), QPointF(rim_mm + 0.6 * Margin_mm, 0.0));
        painter.restore();
    }
    if (m_angle_rad) {
        painter.save();
        painter.rotate(radiansToDegrees(*m_angle_rad));
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_isStale ? theme.muted : theme.accent);
        const double inside_mm = rim_mm - 0.8;
        painter.drawPolygon(QPolygonF({{inside_mm - 2.4, 0.0}, {inside_mm, 1.5}, {inside_mm, -1.5}}));
        painter.restore();
    }
}

void RotorView::drawNames(QPainter& painter, const Theme& theme) const {
    const QTransform toPixels = painter.transform();
    const double sensor_mm = m_geometry.sensorRadius_m * MmPerM;
    const double coil_mm = m_geometry.coil.meanRadius_m * MmPerM;
    struct Name {
        QPointF at_mm;
        QString text;
        QColor ink;
        double height_mm;
    };
    const double beside_mm = 2.8; // of a sensor, clear of the coils
    const std::array names = {
        Name{{sensor_mm - 2.0, beside_mm}, tr("Hall A"), theme.curves[3], SensorName_mm},
        Name{{0.0, sensor_mm - 1.3 * beside_mm}, tr("Hall B"), theme.curves[5], SensorName_mm},
        Name{{-coil_mm, 0.0}, tr("A"), theme.text, CoilName_mm},
        Name{{0.0, -coil_mm}, tr("B"), theme.text, CoilName_mm}};
    painter.save();
    painter.resetTransform();
    const double ratio = painter.device()->devicePixelRatioF();
    painter.scale(ratio, ratio);
    for (const Name& name : names) {
        QFont letters = font();
        const double height_px = name.height_mm * toPixels.m11() / ratio;
        letters.setPixelSize(std::max(LeastName_px, static_cast<int>(std::lround(height_px))));
        painter.setFont(letters);
        QRectF box(0.0, 0.0, 100.0, 100.0);
        box.moveCenter(toPixels.map(name.at_mm) / ratio);
        painter.setPen(name.ink);
        painter.drawText(box, Qt::AlignCenter, name.text);
    }
    painter.restore();
}

/// As long as the arrow of a sensor that reads as much.
void RotorView::drawScale(QPainter& painter, const Theme& theme, double pixels_per_mm) const {
    const double reach_mm = (m_geometry.boreRadius_m() - m_geometry.sensorRadius_m) * MmPerM;
    const double length_px = reach_mm * pixels_per_mm * ScaleArrow_T / ArrowFullScale_T;
    const QString text = fixed(ScaleArrow_T * 1e3, 0) + QStringLiteral(" mT");
    const double below_px = 5.5 * painter.fontMetrics().height(); // the words of the sensors
    const QPointF end(width() - PanelMargin_px, height() - PanelMargin_px - below_px);
    painter.setPen(linePen(painter, theme.muted, 3.0));
    for (const QLineF& line : arrowOf(length_px, std::min(2.2 * pixels_per_mm, 0.6 * length_px))) {
        painter.drawLine(line.translated(end - QPointF(length_px / 2.0, 0.0)));
    }
    painter.drawText(QRectF(0.0, end.y() - 2.4 * painter.fontMetrics().height(), end.x(),
                            1.5 * painter.fontMetrics().height()),
                     Qt::AlignRight | Qt::AlignBottom, text);
}

void RotorView::drawWords(QPainter& painter, const Theme& theme) const {
    const QString dash = QStringLiteral("—");
    double angle_deg = m_angle_rad ? std::fmod(radiansToDegrees(*m_angle_rad), 360.0) : 0.0;
    angle_deg = angle_deg < 0.0 ? angle_deg + 360.0 : angle_deg;
    const QString angle = m_angle_rad ? fixed(angle_deg, 1) + QStringLiteral("°") : dash;
    const auto ampere = [&](double value) {
        return m_current_A ? fixed(value, 2) + QStringLiteral(" A") : dash;
    };
    const auto tesla = [&](double value) {
        return m_hall_T ? fixed(value * 1e3, 1) + QStringLiteral(" mT") : dash;
    };
    const Pair current_A = m_current_A.value_or(Pair{});
    const Pair hall_T = m_hall_T.value_or(Pair{});
    painter.setFont(tabularFont(font()));
    const QRect box = rect().adjusted(PanelMargin_px, PanelMargin_px, -PanelMargin_px, -PanelMargin_px);
    painter.setPen(m_isStale ? theme.muted : theme.text);
    painter.drawText(box, Qt::AlignLeft | Qt::AlignTop, tr("Angle ψ %1").arg(angle));
    painter.drawText(box, Qt::AlignLeft | Qt::AlignBottom,
                     tr("Coil A\n%1\nCoil B\n%2").arg(ampere(current_A.a), ampere(current_A.b)));
    painter.drawText(box, Qt::AlignRight | Qt::AlignBottom,
                     tr("Hall A\n%1\nHall B\n%2").arg(tesla(hall_T.a), tesla(hall_T.b)));
    painter.setPen(theme.muted);
    painter.drawText(box, Qt::AlignRight | Qt::AlignTop,
                     m_isStale && m_angle_rad ? tr("old values") : modelName());
}

} // namespace halbench::widgets
