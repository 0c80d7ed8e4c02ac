"""Logistic regression whose coefficients are never negative: every figure speaks against drilling.

All but the first, the rate, are at least LEAST: far out, a figure alone is reason enough, though others may have spoken
against all that the corpus holds of its kind. A slow breaker is a drill, and what a codec hides is no reason by itself.
"""
import numpy as np

PENALTY = 0.002  # of the squared coefficients: far-out clips alone do not decide
DRILLS = 0.6  # others come near a drill oftener than a drill from 0 dB on comes near them
LEAST = 2.1  # of coefficients: times kMostWeight it is more than the bias
FOLDS = 10


def trained(features, drilling, rounds=4000):
    """Bias and coefficients; whatever their numbers, drills count DRILLS times as much as others."""
    weight = np.where(drilling, DRILLS / max(drilling.sum(), 1), 1 / max((~drilling).sum(), 1)) / (1 + DRILLS)
    target = drilling.astype(float)
    parameters = np.concatenate([[1.0], np.ones(features.shape[1])])
    scale = .25 * (1 + np.sum(features ** 2, 1).max() * .2) + PENALTY
    momentum, before = parameters.copy(), parameters.copy()
    for k in range(rounds):
        logit = momentum[0] - features @ momentum[1:]
        error = weight * (1 / (1 + np.exp(-np.clip(logit, -50, 50))) - target)
        gradient = np.concatenate([[error.sum()], -features.T @ error + PENALTY / len(momentum) * momentum[1:]])
        parameters = momentum - gradient / scale
        parameters[1:] = np.maximum(parameters[1:], [0] + [LEAST] * (features.shape[1] - 1))
        momentum = parameters + k / (k + 3) * (parameters - before)
        before = parameters.copy()
    return parameters[0], parameters[1:]


def probability_of(features, bias, coefficients):
    return 1 / (1 + np.exp(-np.clip(bias - features @ coefficients, -50, 50)))


def cross_validated(features, drilling, sources):
    """Each clip's probability by a model that was trained without any clip of its source."""
    order = {source: k for k, source in enumerate(np.random.default_rng(0).permutation(sorted(set(sources))))}
    fold = np.array([order[source] % FOLDS for source in sources])
    probability = np.zeros(len(sources))
    for k in range(FOLDS):
        bias, coefficients = trained(features[fold != k], drilling[fold != k])
        probability[fold == k] = probability_of(features[fold == k], bias, coefficients)
    return probability


def area_under_curve(probability, drilling):
    drills, others = probability[drilling][:, None], probability[~drilling][None]
    return float(np.mean(drills > others) + .5 * np.mean(drills == others))


def write(path, bias, coefficients):
    """The header between its marks."""
    with open(path) as file:
        text = file.read()
    head, rest = text.split('// made by tests/bench/verdict\n')
    tail = rest[rest.index('// end'):]
    lines = ['constexpr double kBias = %.2f;\n' % bias, 'constexpr std::array<double, kObjections> kCoefficients = {\n']
    lines += ['    %.2f,  // %s\n' % (value, name) for name, value in coefficients.items()] + ['};\n']
    with open(path, 'w') as file:
        file.write(head + '// made by tests/bench/verdict\n' + ''.join(lines) + tail)
