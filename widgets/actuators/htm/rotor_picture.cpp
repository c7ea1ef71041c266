#include "widgets/actuators/htm/rotor_picture.h"

#include "widgets/actuators/htm/hall_trace_view.h"
#include "widgets/actuators/htm/rotor_view.h"

#include <QAction>
#include <QActionGroup>
#include <QHBoxLayout>

namespace halbench::widgets {

namespace {

/// From this shape on the cross-section, which is round, leaves room beside it.
constexpr double WidePicture_ratio = 1.5;

} // namespace

RotorPicture::RotorPicture(QWidget* parent)
    : ActuatorPicture(parent), m_view(new RotorView(this)), m_trace(new HallTraceView(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_view, 3);
    row->addWidget(m_trace, 2);
    m_trace->hide();
    auto* models = new QActionGroup(this);
    const auto add = [&](FieldModel model, const QString& text, const QString& toolTip) {
        auto* choice = new QAction(text, this);
        choice->setToolTip(toolTip);
        choice->setCheckable(true);
        choice->setChecked(model == m_view->fieldModel());
        models->addAction(choice);
        addAction(choice);
        connect(choice, &QAction::triggered, m_view, [this, model] { m_view->setFieldModel(model); });
    };
    add(FieldModel::Ideal, tr("&Ideal"), tr("Field of an ideal Halbach cylinder (Alt+I)"));
    add(FieldModel::Segmented, tr("Se&gmented"), tr("Field of the individual magnets (Alt+G)"));
    add(FieldModel::Measured, tr("Meas&ured"),
        tr("Direction and magnitude measured by the Hall sensors (Alt+U)"));
}

void RotorPicture::showSettings(const ActuatorValues& values) {
    m_view->setCurrentLimit_A(values.parameter("limit.current").value_or(4.0));
}

void RotorPicture::showSamples(const ActuatorValues& values) {
    const auto value = [&](const char* role) { return values.signal(role).value_or(0.0); };
    if (!values.signal("hall.a")) {
        return;
    }
    m_view->setAngle(value("position"));
    m_view->setCurrents(value("current.a"), value("current.b"));
    m_view->setHall(value("hall.a"), value("hall.b"));
    m_trace->add(value("position"), value("hall.a"), value("hall.b"));
}

void RotorPicture::setStale(bool isStale) {
    m_view->setStale(isStale);
    m_trace->setStale(isStale);
}

void RotorPicture::clear() {
    m_view->clear();
    m_trace->clear();
}

void RotorPicture::resizeEvent(QResizeEvent* event) {
    ActuatorPicture::resizeEvent(event);
    m_trace->setVisible(width() >= WidePicture_ratio * height());
}

ActuatorView rotorActuatorView() {
    return {"htm", {"position", "current.a", "current.b", "hall.a", "hall.b"}, {}, [](QWidget* parent) {
                return new RotorPicture(parent);
            }};
}

} // namespace halbench::widgets
