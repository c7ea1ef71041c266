#include "app/workspaces/pace_row.h"

#include "widgets/say_words.h"
#include "widgets/theme_style.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <iterator>

namespace halbench::app {

namespace {

/// Device seconds per wall second; 0 is virtual time.
constexpr double Speeds_ratio[] = {1.0, 5.0, 20.0, 100.0, 0.0};

} // namespace

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
            [this](int index) { m_bench.setPace({Speeds_ratio[index]}); });
    connect(&m_bench, &Workbench::paceChanged, this, &PaceRow::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &PaceRow::refresh);
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &PaceRow::refresh);
    refresh();
}

void PaceRow::sayWords() {
    const QSignalBlocker quiet(m_box);
    const int shown = m_box->currentIndex();
    m_box->clear();
    m_box->addItems(
        {tr("real time"), tr("5 times"), tr("20 times"), tr("100 times"), tr("as fast as possible")});
    m_box->setCurrentIndex(shown);
    m_label->setText(m_place == Place::Devices ? tr("Simulated &time") : tr("Simulated time"));
    m_box->setAccessibleName(tr("Speed of simulated time"));
    m_box->setToolTip(tr("How fast the simulated motor lives: at 20 times a run of two minutes takes six "
                         "seconds.\nA real device has its own time."));
}

void PaceRow::refresh() {
    const DeviceSession& session = m_bench.session();
    const bool isFree = session.state() == SessionState::Disconnected;
    const bool isSimulated = session.info().isSimulated || session.info().transport == "replay";
    setVisible(m_place == Place::Devices || (isSimulated && !isFree));
    m_box->setEnabled((isSimulated || isFree) && session.procedure().isEmpty());
    m_label->setEnabled(m_box->isEnabled());
    const auto* now = std::find(std::begin(Speeds_ratio), std::end(Speeds_ratio), m_bench.pace().speed_ratio);
    const QSignalBlocker quiet(m_box);
    m_box->setCurrentIndex(now == std::end(Speeds_ratio) ? 0
                                                         : static_cast<int>(now - std::begin(Speeds_ratio)));
}

} // namespace halbench::app
