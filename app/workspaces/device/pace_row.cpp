#include "app/workspaces/device/pace_row.h"

#include "app/workbench/pace_steps.h"
#include "widgets/language/translated_text.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace halbench::app {

PaceRow::PaceRow(Workbench& bench, Place place, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_place(place), m_label(new QLabel(this)), m_box(new QComboBox(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(widgets::PanelMargin_px);
    row->addWidget(m_label);
    row->addWidget(m_box, place == Place::Devices ? 1 : 0);
    m_label->setBuddy(m_box);
    widgets::sayWords(*this, [this] { sayWords(); });
    connect(m_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this](int index) { m_bench.setPace({m_box->itemData(index).toDouble()}); });
    connect(&m_bench, &Workbench::paceChanged, this, &PaceRow::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &PaceRow::refresh);
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &PaceRow::refresh);
    refresh();
}

void PaceRow::sayWords() {
    const QSignalBlocker quiet(m_box);
    m_box->clear();
    for (const double speed_ratio : paceSteps()) {
        m_box->addItem(paceWords(speed_ratio), speed_ratio);
    }
    showPace();
    m_label->setText(m_place == Place::Devices ? tr("Simulated &time") : tr("Simulated time"));
    m_box->setAccessibleName(tr("Speed of simulated time"));
    m_box->setToolTip(tr("Speed of the simulated motor or of the replay: 20 times runs two minutes in six "
                         "seconds.\nKeys in the Monitor: < and >. A real device always runs in real time."));
}

void PaceRow::refresh() {
    const DeviceSession& session = m_bench.session();
    const bool isFree = session.state() == SessionState::Disconnected;
    const bool isSimulated = session.info().isSimulated || session.info().transport == "replay";
    setVisible(m_place == Place::Devices || (isSimulated && !isFree));
    m_box->setEnabled((isSimulated || isFree) && session.procedure().isEmpty());
    m_label->setEnabled(m_box->isEnabled());
    showPace();
}

/// A speed that is none of the choices is one from then on.
void PaceRow::showPace() {
    const QSignalBlocker quiet(m_box);
    const double now_ratio = m_bench.pace().speed_ratio;
    int index = m_box->findData(now_ratio);
    if (index < 0) {
        index = m_box->count();
        m_box->addItem(paceWords(now_ratio), now_ratio);
    }
    m_box->setCurrentIndex(index);
}

} // namespace halbench::app
