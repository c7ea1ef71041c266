#include "app/workspaces/device/link_panel.h"

#include "app/workbench/fault_words.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QHBoxLayout>
#include <QLabel>

namespace halbench::app {

namespace {

/// Shortest stretch of device time over which a rate is worth showing.
constexpr double RateWindow_s = 0.5;

} // namespace

LinkPanel::LinkPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_link = new QLabel(this);
    m_link->setAccessibleName(tr("Link statistics"));
    m_link->setToolTip(
        tr("Packets per second of device time, packets lost and damaged, median and worst answer time"));
    m_link->setFont(widgets::tabularFont(font()));
    m_board = new QLabel(this);
    m_board->setAccessibleName(tr("Board"));
    m_board->setToolTip(tr("Firmware of the board and its state in words"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px, widgets::PanelMargin_px,
                            widgets::GridStep_px);
    row->setSpacing(widgets::GroupSpacing_px);
    row->addWidget(m_link);
    row->addWidget(m_board, 1);
    // Figures that grow must not widen the window beyond a small screen.
    m_link->setMinimumWidth(1);
    m_board->setMinimumWidth(1);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &LinkPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &LinkPanel::refresh);
    refresh();
}

void LinkPanel::refresh() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected) {
        m_link->setText(session.state() == SessionState::Connecting     ? tr("link: connecting")
                        : session.state() == SessionState::Reconnecting ? tr("link: lost, reconnecting")
                                                                        : tr("link: none"));
        m_board->clear();
        m_packets = 0;
        m_time_s = 0.0;
        return;
    }
    const devices::LinkStatistics& link = session.report().statistics;
    const double time_s = session.report().deviceTime_s;
    if (time_s - m_time_s >= RateWindow_s) {
        m_rate_Hz = static_cast<double>(link.packetsReceived - m_packets) / (time_s - m_time_s);
        m_packets = link.packetsReceived;
        m_time_s = time_s;
    }
    m_link->setText(tr("link: %1 packets/s, %2 lost, %3 damaged, %4 ms (worst %5 ms)")
                        .arg(widgets::fixedText(m_rate_Hz, 0), widgets::countText(link.packetsLost),
                             widgets::countText(link.packetsDamaged),
                             widgets::fixedText(link.roundTripMedian_s * 1e3, 1),
                             widgets::fixedText(link.roundTripWorst_s * 1e3, 1)));
    const QString fault = faultWords(session.report().board, m_bench.stopAsker()).what;
    m_board->setText(tr("board: firmware %1%2")
                         .arg(QString::fromStdString(session.info().firmware),
                              fault.isEmpty() ? QString() : tr(", %1").arg(fault)));
}

} // namespace halbench::app
