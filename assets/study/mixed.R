# Ratings of single answers by a metric, with people and patterns as they are: a mixed model of this
# report's answers.csv and pairs.csv.
#
#     Rscript mixed.R [FOLDER] [METRIC] [lme4|brms]        default: this folder, pm, lme4
#
# dissimilarity (100 - similarity) of an answer = what the metric says of the pair, in standard deviations,
# with a slope of each participant's own; participants, both patterns of a pair and the pair itself differ at
# random. The slope is in points of 100 for one standard deviation of the metric. Synthetic answers are said.
#
# Needs lme4 (r-cran-lme4), or brms with a compiler for Stan.

arguments <- commandArgs(trailingOnly = TRUE)
script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE))
folder <- if (length(arguments) > 0) arguments[1] else if (length(script) > 0) dirname(script) else "."
metric <- if (length(arguments) > 1) arguments[2] else "pm"
engine <- if (length(arguments) > 2) arguments[3] else "lme4"

rows <- function(file) read.csv(file.path(folder, file), check.names = FALSE, encoding = "UTF-8")
answers <- rows("answers.csv")
pairs <- rows("pairs.csv")
if (!"rating" %in% names(answers)) stop("answers.csv: expected ratings of pairs, got sortings")
if (!metric %in% names(pairs)) {
    stop("expected a metric of pairs.csv, got ", metric, ": ",
         paste(setdiff(names(pairs), c("a", "b", "people", "synthetic", "left_out", "rehearsals")), collapse = ", "))
}
answers <- answers[answers$excluded == 0 & answers$attention == 0, ]
if (any(answers$synthetic == 1)) cat("SYNTHETIC: nobody was asked for some of the answers\n")
place <- match(paste(answers$a, answers$b), paste(pairs$a, pairs$b))
answers$predicted <- as.vector(scale(pairs[[metric]]))[place]
answers$pair <- paste(answers$a, answers$b)
answers$dissimilarity <- 100 - answers$rating
answers <- answers[!is.na(answers$predicted), ]
cat(nrow(answers), "answers of", length(unique(answers$participant)), "participants about",
    length(unique(answers$pair)), "pairs;", metric, "in standard deviations\n\n")

model <- dissimilarity ~ predicted + (1 + predicted | participant) + (1 | a) + (1 | b) + (1 | pair)
if (engine == "brms") {
    print(summary(brms::brm(model, data = answers, seed = 1, refresh = 0)))
} else {
    fit <- lme4::lmer(model, data = answers)
    print(summary(fit), correlation = FALSE)
    slope <- lme4::fixef(fit)[["predicted"]]
    error <- sqrt(diag(as.matrix(vcov(fit))))[["predicted"]]
    cat(sprintf("\nslope of %s: %.2f points, 95 %% interval %.2f to %.2f (1.96 standard errors)\n", metric, slope,
                slope - 1.96 * error, slope + 1.96 * error))
}
