#pragma once

#include "widgets/log/log_table_model.h"

#include <QSortFilterProxyModel>

namespace halbench::widgets {

/// Messages of at least a level whose source and text contain the words.
class LogFilterModel : public QSortFilterProxyModel {
    Q_OBJECT
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setLeast(LogLevel level);
    void setWords(const QString& words);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    LogLevel m_least = LogLevel::Information;
    QString m_words;
};

} // namespace halbench::widgets
