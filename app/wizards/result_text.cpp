#include "app/wizards/result_text.h"

#include "app/wizards/identify_text.h"
#include "app/workspaces/parts/quality_view.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/theme/theme_style.h"

#include <QLabel>
#include <QVBoxLayout>

namespace halbench::app {

ResultWords::ResultWords(QWidget* remark, QWidget* parent)
    : QWidget(parent), m_verdict(new widgets::VerdictView(this)), m_table(new widgets::EstimateTable(this)),
      m_use(new QLabel(this)), m_provenance(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    for (QLabel* label : {m_use, m_provenance}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    widgets::setRole(*m_provenance, widgets::Role::Muted);
    column->addWidget(m_verdict);
    column->addWidget(m_table);
    if (remark != nullptr) {
        column->addWidget(remark);
    }
    column->addWidget(m_use);
    column->addWidget(m_provenance);
    column->addStretch(1);
}

void ResultWords::setQuality(const DataQuality& quality) {
    m_verdict->setVerdict(verdictLevel(quality.verdict), verdictTitle(quality), remarksOf(quality.findings));
}

void ResultWords::setUse(const QString& words) {
    m_use->setText(words);
    m_use->setVisible(!words.isEmpty());
}

void ResultWords::setProvenance(const QString& words) {
    m_provenance->setText(words);
}

} // namespace halbench::app
