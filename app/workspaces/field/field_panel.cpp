#include "app/workspaces/field/field_panel.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/actuators/htm/rotor_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {

namespace {

constexpr const char* Roles[] = {"position", "current.a", "current.b", "hall.a", "hall.b"};

} // namespace

FieldPanel::FieldPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makePanelColumn(this);
    m_view = new widgets::RotorView(this);
    column->addWidget(buildToggles());
    column->addWidget(m_view, 1);
    m_words = makeNote(this);
    column->addWidget(m_words);
    connect(&m_bench, &Workbench::deviceChanged, this, &FieldPanel::onDevice);
    connect(&m_bench, &Workbench::valuesChanged, this,
            [this] { m_view->setCurrentLimit_A(m_bench.deviceValue("limit.current").value_or(4.0)); });
    connect(&m_bench, &Workbench::samplesArrived, this, &FieldPanel::onSamples);
    connect(&m_bench.freshness(), &Freshness::changed, this,
            [this] { m_view->setStale(m_bench.freshness().isStale()); });
    onDevice();
}

QWidget* FieldPanel::buildToggles() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::GridStep_px);
    m_models = new QButtonGroup(this);
    const auto add = [&](widgets::FieldModel model, const PushAction& action) {
        QPushButton* button = makeButton(action, box);
        button->setCheckable(true);
        m_models->addButton(button, static_cast<int>(model));
        row->addWidget(button);
    };
    add(widgets::FieldModel::Ideal, {tr("&Ideal"), tr("Field of an ideal Halbach cylinder (Alt+I)"), {}});
    add(widgets::FieldModel::Segmented, {tr("Se&gmented"), tr("Field of its separate magnets (Alt+G)"), {}});
    add(widgets::FieldModel::Measured,
        {tr("Meas&ured"), tr("Direction and size that the Hall sensors see (Alt+U)"), {}});
    row->addStretch(1);
    m_models->button(static_cast<int>(widgets::FieldModel::Ideal))->setChecked(true);
    connect(m_models, &QButtonGroup::idClicked, this,
            [this](int model) { m_view->setFieldModel(static_cast<widgets::FieldModel>(model)); });
    return box;
}

void FieldPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    std::vector<std::string> names;
    for (const char* role : Roles) {
        const std::string name = session.catalogue().signalForRole(role);
        if (!name.empty()) {
            names.push_back(name);
        }
    }
    const bool isKnown = names.size() == std::size(Roles);
    if (session.state() == SessionState::Connected) {
        m_view->clear();
        m_bench.liveSignals().want(this, names);
    }
    m_words->setText(isKnown ? QString() : tr("Shows the rotor of a connected motor with Hall sensors."));
    m_words->setVisible(!isKnown);
}

double FieldPanel::latest(const char* role) const {
    const auto value = m_bench.history().latest(m_bench.session().catalogue().signalForRole(role));
    return value ? value->value : 0.0;
}

void FieldPanel::onSamples() {
    if (!isVisible() || !m_bench.history().contains(m_bench.session().catalogue().signalForRole("hall.a"))) {
        return;
    }
    m_view->setAngle(latest("position"));
    m_view->setCurrents(latest("current.a"), latest("current.b"));
    m_view->setHall(latest("hall.a"), latest("hall.b"));
}

} // namespace halbench::app
