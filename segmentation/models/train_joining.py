#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Learn whether two pieces are one object, or how well a union of pieces fits one: boosted trees from the examples
of pcl_joining_examples.

    train_joining.py trees.txt FEATURES TREES RATE EXAMPLES ...

Deterministic: the same examples give the same trees. Needs numpy and scikit-learn.
"""
import sys

import numpy
from sklearn.ensemble import HistGradientBoostingClassifier

LEAVES = 15
LEAST_EXAMPLES = 40  # in a leaf


def read_examples(paths, features):
    """Rows of: is an object, weight, features."""
    rows = []
    for path in paths:
        try:
            values = numpy.fromfile(path, numpy.float32)
        except OSError as error:
            sys.exit(str(error))
        if len(values) % (2 + features) != 0:
            sys.exit("%s: not made of rows of 2 + %d numbers" % (path, features))
        rows.append(values.reshape(-1, 2 + features))
    rows = numpy.concatenate(rows)
    if len(numpy.unique(rows[:, 0])) != 2:
        sys.exit("there must be both examples that are an object and others")
    return rows


def train(rows, trees, rate):
    """Trees whose sum is the log-odds of an object."""
    model = HistGradientBoostingClassifier(
        max_iter=trees, max_leaf_nodes=LEAVES, learning_rate=rate, min_samples_leaf=LEAST_EXAMPLES,
        l2_regularization=1.0, early_stopping=False, random_state=0)
    weights = rows[:, 1] / rows[:, 1].mean()
    return model.fit(rows[:, 2:], rows[:, 0], sample_weight=weights)


def nodes_of(tree):
    """Nodes breadth first, so that the two that follow one are side by side: feature, next, value; leaves: value."""
    nodes, order, next_place = [], [0], 1
    for number in order:  # grows
        node = tree.nodes[number]
        if node["is_leaf"]:
            nodes.append("v%.4g" % node["value"])
        else:
            nodes.append("%d %d %.6g" % (node["feature_idx"], next_place, node["num_threshold"]))
            order += [node["left"], node["right"]]
            next_place += 2
    return nodes


def text_of(model, features):
    """What pcl::indoor::BoostedTrees::read() reads."""
    trees = [stage[0] for stage in model._predictors]
    lines = ["trees %d %.6g %d" % (features, model._baseline_prediction.item(), len(trees))]
    for tree in trees:
        nodes = nodes_of(tree)
        lines += [str(len(nodes))] + nodes
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    try:
        features, trees, rate = int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4])
    except ValueError:
        sys.exit(__doc__)
    rows = read_examples(sys.argv[5:], features)
    with open(sys.argv[1], "w", encoding="ascii") as file:
        file.write(text_of(train(rows, trees, rate), features))
    print("%d examples, %.1f %% of them an object" % (len(rows), 100 * rows[:, 0].mean()))


if __name__ == "__main__":
    main()
