#include "app/workspaces/parts/foreign_motor_notice.h"

#include "app/documents/result_header.h"
#include "app/workbench/shared_results.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>

namespace halbench::app {

ForeignMotorNotice::ForeignMotorNotice(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_symbol(new QLabel(this)), m_words(new QLabel(this)),
      m_consent(new QCheckBox(this)) {
    setObjectName(QStringLiteral("foreign"));
    m_words->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(widgets::PanelMargin_px);
    grid->setVerticalSpacing(widgets::GridStep_px);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_symbol, 0, 0, Qt::AlignTop);
    grid->addWidget(m_words, 0, 1);
    grid->addWidget(m_consent, 1, 0, 1, 2);
    connect(m_consent, &QCheckBox::toggled, this, &ForeignMotorNotice::changed);
    connect(&m_bench, &Workbench::deviceChanged, this, &ForeignMotorNotice::forget);
    connect(&m_bench, &Workbench::identificationChanged, this, &ForeignMotorNotice::forget);
    refresh();
}

std::optional<Finding> ForeignMotorNotice::finding() const {
    const DeviceSession& session = m_bench.session();
    const bool isKnown = m_bench.identification() && session.state() == SessionState::Connected;
    return isKnown ? foreignMotor(m_bench.provenance().header.device, session.info()) : std::nullopt;
}

bool ForeignMotorNotice::isAllowed() const {
    return !finding() || m_bench.session().info().isSimulated || m_consent->isChecked();
}

/// Consent is for one motor on one device.
void ForeignMotorNotice::forget() {
    m_consent->setChecked(false);
    refresh();
    Q_EMIT changed();
}

void ForeignMotorNotice::refresh() {
    const std::optional<Finding> foreign = finding();
    setVisible(foreign.has_value());
    m_consent->setText(tr("Apply the gains of another motor"));
    m_consent->setToolTip(tr("The gains were designed for a motor that may differ from this one"));
    m_consent->setVisible(foreign && !m_bench.session().info().isSimulated);
    setAccessibleName(tr("Motor that the gains are designed for"));
    if (foreign) {
        m_symbol->setPixmap(
            widgets::themedIcon(QStringLiteral("warning"), widgets::Role::Warn).pixmap(16, 16));
        m_words->setText(widgets::inWords(foreign->message) + QStringLiteral(" \u2192 ") +
                         widgets::inWords(foreign->hint));
    }
}

void ForeignMotorNotice::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
        refresh();
    }
}

} // namespace halbench::app
