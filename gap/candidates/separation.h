#pragma once

#include "gap/candidates/candidates.h"

namespace gap {

/// How much nearer to held-out data one candidate is than a rival, in standard deviations of that difference if the
/// first were right. Below two the data hardly tell them apart.
[[nodiscard]] double separation(const Judge& judge, const Candidate& best, const Candidate& rival);
/// The same on the samples that both were fitted to as well, which is fair if both have as many free numbers. `quick`
/// sees some of the beams: enough for these samples. Edges take part where they do on held-out samples. 0 if the rival
/// is farther by no more than the share `alike` of what the first explains, on either part of the samples.
[[nodiscard]] double separationOnAll(const Judge& quick, const Judge& exact, const Candidate& best,
                                     const Candidate& rival, double alike);
/// The same, but no more than the difference says as a ratio of likelihoods: of two that are nearly one, and both a
/// little off, the nearer is nearer by many standard deviations of a fraction of a nat. The rival's `price` in nats
/// tells it from the best, too (twice the logarithm of a likelihood ratio is the square of its z), but for what the
/// rival is nearer by on all samples together, beyond what is `alike`. At least 0.
[[nodiscard]] double toldFromOnAll(const Judge& quick, const Judge& exact, const Candidate& best,
                                   const Candidate& rival, double alike, double price = 0.0);
/// What a world would gain over the null on held-out data if it were right, in nats.
[[nodiscard]] double gainWereItRight(const Judge& judge, const World& null, const World& world);

}  // namespace gap
