#include "app/workspaces/field/field_panel.h"

#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/drive_orders.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/actuators/registry/actuator_views.h"
#include "widgets/figure/painting.h"
#include "widgets/language/phrasebook.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPicture>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

namespace halbench::app {

namespace {

constexpr QSize PictureSize_px(1000, 700);

} // namespace

const widgets::ActuatorView* pictureOf(const devices::Catalogue& catalogue) {
    return widgets::actuatorViewFor(
        [&](const std::string& role) { return !catalogue.signalForRole(role).empty(); });
}

bool hasPicture(const devices::Catalogue& catalogue) {
    return pictureOf(catalogue) != nullptr;
}

FieldPanel::FieldPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    QVBoxLayout* column = makePanelColumn(this);
    m_tools = new QHBoxLayout;
    m_tools->setSpacing(widgets::GridStep_px);
    m_save = makeButton({tr("Save &picture…"), tr("Save as SVG, PDF or PNG (Alt+P)"), {}}, this);
    connect(m_save, &QPushButton::clicked, this, &FieldPanel::savePicture);
    m_tools->addWidget(m_save);
    m_tools->addStretch(1);
    column->addLayout(m_tools);
    m_place = new QVBoxLayout;
    column->addLayout(m_place, 1);
    m_numbers = new QLabel(this);
    m_numbers->setWordWrap(true);
    m_numbers->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(m_numbers);
    m_words = makeNote(this);
    column->addWidget(m_words);
    choose(widgets::actuatorViews().front());
    connect(&m_bench, &Workbench::deviceChanged, this, &FieldPanel::onDevice);
    const auto showSettings = [this] { m_picture->showSettings(values()); };
    connect(&m_bench, &Workbench::valuesChanged, this, showSettings);
    connect(&m_bench.drive(), &DriveControl::changed, this, showSettings); // the mode
    connect(&m_bench, &Workbench::samplesArrived, this, &FieldPanel::onSamples);
    connect(&m_bench.freshness(), &Freshness::changed, this,
            [this] { m_picture->setStale(m_bench.freshness().isStale()); });
    onDevice();
}

void FieldPanel::addTool(QAction* action) {
    QPushButton* button = makeButton({action->text(), action->toolTip(), {}}, this);
    button->setCheckable(action->isCheckable());
    button->setChecked(action->isChecked());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    connect(action, &QAction::toggled, button, &QPushButton::setChecked);
    connect(m_picture, &QObject::destroyed, button, &QObject::deleteLater);
    m_tools->insertWidget(m_tools->count() - 2, button); // before saving
}

void FieldPanel::choose(const widgets::ActuatorView& view) {
    if (m_view == &view) {
        return;
    }
    delete m_picture;
    m_view = &view;
    m_picture = view.make(this);
    m_place->addWidget(m_picture);
    for (QAction* action : m_picture->actions()) {
        addTool(action);
    }
    m_save->setVisible(static_cast<bool>(m_picture->drawing()));
}

/// The picture of a device that is lost stays, as its last values.
void FieldPanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected) {
        m_words->setText(tr("Shows the rotor or platen of a connected actuator, with its field."));
        m_words->setVisible(session.state() == SessionState::Disconnected);
        return;
    }
    const widgets::ActuatorView* view = pictureOf(session.catalogue());
    std::vector<std::string> wanted;
    if (view != nullptr) {
        choose(*view);
        for (const std::vector<std::string>* roles : {&view->needed, &view->wished}) {
            for (const std::string& role : *roles) {
                wanted.push_back(signalOfRole(session.catalogue(), role)); // what is not there is left out
            }
        }
    }
    m_picture->clear();
    m_numbers->clear();
    m_numbers->setVisible(false);
    m_picture->setVisible(view != nullptr);
    m_bench.liveSignals().want(this, std::move(wanted));
    m_words->setText(tr("This device has no signals that a picture could be made of."));
    m_words->setVisible(view == nullptr);
    m_picture->showSettings(values());
}

widgets::ActuatorValues FieldPanel::values() const {
    const auto signal = [this](const std::string& role) -> std::optional<double> {
        const auto value = m_bench.history().latest(signalOfRole(m_bench.session().catalogue(), role));
        return value && std::isfinite(value->value) ? std::optional(value->value) : std::nullopt;
    };
    const auto parameter = [this](const std::string& role) {
        // The mode goes with every motion, and is not read back.
        return role == "hb.mode" ? std::optional(codeOf(m_bench.drive().mode()))
                                 : m_bench.deviceValue(parameterOfRole(m_bench.session().catalogue(), role));
    };
    return {signal, parameter};
}

void FieldPanel::onSamples() {
    if (!isVisible() || m_view == nullptr) {
        return;
    }
    m_picture->showSamples(values());
    const QString numbers = m_picture->numbers();
    m_numbers->setText(numbers);
    m_numbers->setVisible(!numbers.isEmpty());
}

/// As it is now, not after the dialog: its lines are kept and drawn again.
void FieldPanel::savePicture() {
    QPicture lines;
    QPainter recorder(&lines);
    m_picture->drawing()(recorder, widgets::paperTheme(), PictureSize_px);
    recorder.end();
    const auto taken = [title = m_view->id, lines](const QString& path) {
        widgets::Painting painting;
        painting.title = title;
        painting.size = PictureSize_px;
        painting.paint = [lines](QPainter& painter, const widgets::Theme&) {
            QPicture(lines).play(&painter);
        };
        const auto format = widgets::pictureFormat(path).value_or(widgets::PictureFormat::Svg);
        return widgets::pictureWriting(widgets::fileOf(painting, widgets::paperTheme(), format), path);
    };
    app::savePicture(this, m_chooser, QString::fromStdString(m_view->id) + QStringLiteral(".svg"), m_files,
                     taken, [this](const Error& error) {
                         m_words->setText(widgets::inWords(error.message) + QStringLiteral(": ") +
                                          widgets::inWords(error.hint));
                         m_words->setVisible(true);
                     });
}

} // namespace halbench::app
