#include "app/workspaces/device/link_panel.h"

#include "widgets/controls/elided_label.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace halbench::app {

namespace {

/// Shortest stretch of device time over which a rate is worth showing.
constexpr double RateWindow_s = 0.5;
constexpr int LeastLine = 10; ///< characters of the last message; the rest in its tooltip

} // namespace

LinkPanel::LinkPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_link = new widgets::ElidedLabel(LeastLine, this);
    m_link->setAccessibleName(tr("Link statistics"));
    m_link->setToolTip(
        tr("Packets per second (device time), lost, damaged, response time median and maximum"));
    m_link->setFont(widgets::tabularFont(font()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(widgets::PanelMargin_px, 0, widgets::PanelMargin_px, 0);
    row->setSpacing(widgets::GroupSpacing_px);
    m_log = new QToolButton(this);
    m_log->setText(tr("Log"));
    m_log->setToolTip(tr("Unfold or fold the log (F9)"));
    m_log->setFocusPolicy(Qt::NoFocus); // F9 is its key
    m_log->setAutoRaise(true);
    connect(m_log, &QToolButton::clicked, this, &LinkPanel::logRequested);
    m_line = new widgets::ElidedLabel(LeastLine, this);
    m_line->setAccessibleDescription(tr("Last message of the log"));
    row->addWidget(m_log);
    row->addWidget(m_line, 1);
    row->addWidget(m_link);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &LinkPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &LinkPanel::refresh);
    refresh();
}

void LinkPanel::showLine(MessageLevel level, const QString& text) {
    m_line->setWords(text);
    widgets::setRole(*m_line, level == MessageLevel::Error     ? widgets::Role::Bad
                              : level == MessageLevel::Warning ? widgets::Role::Warn
                                                               : widgets::Role::Muted);
}

void LinkPanel::refresh() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected) {
        m_link->setWords(session.state() == SessionState::Connecting     ? tr("link: connecting")
                         : session.state() == SessionState::Reconnecting ? tr("link: lost, reconnecting")
                                                                         : tr("link: none"));
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
    if (session.info().isSimulated || session.info().transport == "replay") {
        m_link->setWords({}); // there is none
        return;
    }
    m_link->setWords(tr("link: %1 packets/s, %2 lost, %3 damaged, %4 ms (max. %5 ms)")
                         .arg(widgets::fixedText(m_rate_Hz, 0), widgets::countText(link.packetsLost),
                              widgets::countText(link.packetsDamaged),
                              widgets::fixedText(link.roundTripMedian_s * 1e3, 1),
                              widgets::fixedText(link.roundTripWorst_s * 1e3, 1)));
}

} // namespace halbench::app
