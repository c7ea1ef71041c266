#include "widgets/controls/progress_row.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int Steps = 1000;

} // namespace

QString durationText(double duration_s) {
    const auto total = static_cast<qint64>(std::llround(std::clamp(duration_s, 0.0, 359999.0)));
    const auto padded = [](qint64 number) {
        return QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0'));
    };
    const qint64 hours = total / 3600;
    const qint64 minutes = total / 60 % 60;
    return hours > 0 ? QStringLiteral("%1:%2:%3").arg(hours).arg(padded(minutes), padded(total % 60))
                     : QStringLiteral("%1:%2").arg(minutes).arg(padded(total % 60));
}

ProgressRow::ProgressRow(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)), m_share(new QLabel(this)),
      m_remaining(new QLabel(this)), m_cancel(new QPushButton(this)) {
    m_bar->setRange(0, Steps);
    m_bar->setTextVisible(false);
    m_share->setFont(tabularFont(font()));
    m_share->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_share->setMinimumWidth(m_share->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    m_remaining->setFont(tabularFont(font()));
    m_remaining->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setRole(*m_remaining, Role::Muted);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(PanelMargin_px);
    grid->setVerticalSpacing(GridStep_px);
    grid->addWidget(m_text, 0, 0);
    grid->addWidget(m_remaining, 0, 1);
    grid->addWidget(m_bar, 1, 0, 1, 2);
    grid->addWidget(m_share, 1, 2);
    grid->addWidget(m_cancel, 0, 3, 2, 1);
    grid->setColumnStretch(0, 1);
    setFocusProxy(m_cancel);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        setCancelling();
        Q_EMIT cancelRequested();
    });
    refreshWords();
}

void ProgressRow::setText(const QString& text) {
    m_text->setText(text);
    setAccessibleName(text);
    m_bar->setAccessibleName(text);
}

void ProgressRow::setProgress(std::optional<double> fraction, std::optional<double> remaining_s) {
    m_isCancelling = false;
    m_remaining_s = remaining_s;
    const double share = fraction ? std::clamp(*fraction, 0.0, 1.0) : 0.0;
    m_bar->setRange(0, fraction ? Steps : 0);
    m_bar->setValue(static_cast<int>(std::lround(share * Steps)));
    // Rounded down: 100 % means done.
    const int percent = static_cast<int>(std::floor(share * 100.0));
    m_share->setText(fraction ? countText(static_cast<quint64>(percent)) + QStringLiteral(" %") : QString());
    refreshWords();
}

void ProgressRow::setCancelling() {
    m_isCancelling = true;
    refreshWords();
}

void ProgressRow::refreshWords() {
    m_cancel->setText(m_isCancelling ? tr("Cancelling…") : tr("Cancel"));
    m_cancel->setToolTip(tr("Cancel and restore the previous state"));
    m_cancel->setAccessibleName(tr("Cancel"));
    m_cancel->setEnabled(!m_isCancelling);
    m_remaining->setText(m_isCancelling || !m_remaining_s ? QString()
                                                          : tr("%1 left").arg(durationText(*m_remaining_s)));
}

void ProgressRow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::widgets
