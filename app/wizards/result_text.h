#pragma once

#include "app/documents/result_header.h"

#include <QWidget>

class QLabel;

namespace halbench::widgets {
class EstimateTable;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

/// A result in words, as every procedure has it: verdict with findings, values with their intervals, what
/// they are for or what is missing, provenance.
class ResultWords : public QWidget {
    Q_OBJECT
public:
    /// `remark`, if any, stands between the values and what they are for.
    explicit ResultWords(QWidget* remark = nullptr, QWidget* parent = nullptr);

    widgets::EstimateTable& table() { return *m_table; }
    void setQuality(const DataQuality& quality);
    void setUse(const QString& words); ///< empty: takes no room
    void setProvenance(const QString& words);

private:
    widgets::VerdictView* m_verdict = nullptr;
    widgets::EstimateTable* m_table = nullptr;
    QLabel* m_use = nullptr;
    QLabel* m_provenance = nullptr;
};

} // namespace halbench::app
