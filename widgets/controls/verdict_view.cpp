#include "widgets/controls/verdict_view.h"

#include "widgets/theme/icons.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace halbench::widgets {
namespace {

Role roleOfLevel(VerdictLevel level) {
    return level == VerdictLevel::Good       ? Role::Good
           : level == VerdictLevel::Doubtful ? Role::Warn
                                             : Role::Bad;
}

QString iconOfLevel(VerdictLevel level) {
    return level == VerdictLevel::Good       ? QStringLiteral("ok")
           : level == VerdictLevel::Doubtful ? QStringLiteral("warning")
                                             : QStringLiteral("error");
}

/// Of a title that nothing follows.
QString withoutColon(const QString& title) {
    const bool hasColon = title.endsWith(QLatin1Char(':')) || title.endsWith(QChar(0xFF1A)); // Chinese
    return hasColon ? title.chopped(1) : title;
}

} // namespace

VerdictView::VerdictView(QWidget* parent)
    : QWidget(parent), m_symbol(new QLabel(this)), m_title(new QLabel(this)), m_words(new QLabel(this)) {
    m_title->setProperty("heading", true);
    m_title->setWordWrap(true);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(PanelMargin_px);
    grid->setVerticalSpacing(GridStep_px);
    grid->addWidget(m_symbol, 0, 0, Qt::AlignTop);
    grid->addWidget(m_title, 0, 1);
    grid->addWidget(m_words, 1, 1);
    grid->setColumnStretch(1, 1);
    for (QLabel* label : {m_title, m_words}) {
        label->installEventFilter(this);
    }
}

void VerdictView::setVerdict(VerdictLevel level, const QString& title, const std::vector<Remark>& remarks) {
    m_level = level;
    m_titleText = title;
    m_remarks = remarks;
    refresh();
}

QString VerdictView::text() const {
    QString lines = m_titleText;
    for (const Remark& remark : m_remarks) {
        lines +=
            QLatin1Char('\n') + remark.message + (remark.hint.isEmpty() ? QString() : "; " + remark.hint);
    }
    return lines;
}

void VerdictView::moveRemarks(QVBoxLayout& place) {
    layout()->removeWidget(m_words);
    place.addWidget(m_words); // its parent is that of the place
}

void VerdictView::refresh() {
    m_symbol->setPixmap(themedIcon(iconOfLevel(m_level), roleOfLevel(m_level)).pixmap(16, 16));
    m_title->setText(m_words->parentWidget() == this ? m_titleText : withoutColon(m_titleText));
    setRole(*m_title, roleOfLevel(m_level));
    QStringList lines;
    for (const Remark& remark : m_remarks) {
        lines << QStringLiteral("\u2022 ") + remark.message;
        if (!remark.hint.isEmpty()) {
            lines << QStringLiteral("   \u2192 ") + remark.hint;
        }
    }
    m_words->setText(lines.join(QLatin1Char('\n')));
    m_words->setAccessibleName(tr("Findings"));
    m_words->setVisible(!lines.isEmpty());
    setAccessibleName(m_titleText);
    setAccessibleDescription(text());
    keepLinesWhole();
}

/// The labels get their width after this widget got its own.
bool VerdictView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        keepLinesWhole();
    }
    return QWidget::eventFilter(watched, event);
}

/// A scroll area asks for smallest sizes, and a label's does not know into how many lines its words break.
void VerdictView::keepLinesWhole() {
    for (QLabel* label : {m_title, m_words}) {
        label->setMinimumHeight(0); // a label counts its minimum in
        label->setMinimumHeight(std::max(0, label->heightForWidth(label->width())));
    }
}

void VerdictView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
        refresh();
    }
}

} // namespace halbench::widgets
