#include "widgets/actuators/htm/rotor_view.h"

#include "control/base/units.h"

#include <QEvent>

#include <cmath>

namespace halbench::widgets {

RotorView::RotorView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    cacheMagnets();
    describe();
}

void RotorView::setGeometryOf(const RotorGeometry& geometry) {
    m_geometry = geometry;
    m_pieces = {};
    cacheMagnets();
    update();
}

void RotorView::setFieldModel(FieldModel model) {
    m_model = model;
    describe();
    update();
}

void RotorView::setCurrentLimit_A(double limit_A) {
    m_currentLimit_A = limit_A;
    update();
}

void RotorView::setAngle(double angle_rad) {
    m_angle_rad = std::isfinite(angle_rad) ? std::optional(angle_rad) : std::nullopt;
    describe();
    update();
}

void RotorView::setCurrents(double current_a_A, double current_b_A) {
    const bool isFinite = std::isfinite(current_a_A) && std::isfinite(current_b_A);
    m_current_A = isFinite ? std::optional(Pair{current_a_A, current_b_A}) : std::nullopt;
    update();
}

void RotorView::setHall(double hall_a_T, double hall_b_T) {
    const bool isFinite = std::isfinite(hall_a_T) && std::isfinite(hall_b_T);
    m_hall_T = isFinite ? std::optional(Pair{hall_a_T, hall_b_T}) : std::nullopt;
    update();
}

void RotorView::setStale(bool isStale) {
    m_isStale = isStale;
    describe();
    update();
}

void RotorView::clear() {
    m_angle_rad.reset();
    m_current_A.reset();
    m_hall_T.reset();
    describe();
    update();
}

QString RotorView::modelName() const {
    switch (m_model) {
    case FieldModel::Segmented:
        return tr("%n separate magnets", nullptr, m_geometry.ring.bars);
    case FieldModel::Measured:
        return tr("as measured by the Hall sensors");
    case FieldModel::Ideal:
        break;
    }
    return tr("ideal cylinder");
}

void RotorView::describe() {
    setAccessibleName(tr("Cross-section of the rotor"));
    const QString angle = m_angle_rad
                              ? tr("rotor at %1 degrees").arg(std::lround(radiansToDegrees(*m_angle_rad)))
                              : tr("angle unknown");
    const QString words = m_isStale ? tr("%1 (old); field: %2").arg(angle, modelName())
                                    : tr("%1; field: %2").arg(angle, modelName());
    if (words != accessibleDescription()) {
        setAccessibleDescription(words);
    }
}

void RotorView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    update();
}

} // namespace halbench::widgets
