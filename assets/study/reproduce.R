# The numbers of this report again, from its CSV files alone, by another program than made it.
#
#     Rscript reproduce.R [FOLDER]
#
# Needs nothing but R. A line each: what it is, the report's number, the one found here, and whether
# they agree. Exact ones agree to 1e-6; what is drawn at random is drawn anew here, so those agree
# within the tolerance that the line tells. Ends with 1 if any differs.
#
# Not tried: the spread and the intervals of K, which take maps that the report does not hold.

arguments <- commandArgs(trailingOnly = TRUE)
script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE))
folder <- if (length(arguments) > 0) arguments[1] else if (length(script) > 0) dirname(script) else "."
exact <- 1e-6
differing <- 0
set.seed(1)

rows <- function(file) {
    read.csv(file.path(folder, file), check.names = FALSE, encoding = "UTF-8",
             colClasses = "character", na.strings = character(0))
}
number <- function(text) suppressWarnings(as.numeric(ifelse(text %in% c("", "NA"), NA, text)))

check <- function(what, of_report, here, tolerance = exact) {
    unknown <- is.na(of_report) && is.na(here)
    agrees <- unknown || isTRUE(abs(of_report - here) <= tolerance * max(1, abs(of_report)))
    if (!agrees) differing <<- differing + 1
    drawn <- if (tolerance == exact) "" else sprintf(" (drawn anew, within %g)", tolerance)
    cat(sprintf("%s %-44s %12.6g %12.6g%s\n", if (agrees) "ok     " else "DIFFERS", what, of_report,
                here, drawn))
}

# Of values that differ by more than a billionth of the largest; ties share the mean rank.
ranks <- function(values) rank(round(values / max(abs(values), 1e-6) * 1e9))
spearman <- function(a, b) {
    known <- is.finite(a) & is.finite(b)
    if (sum(known) < 2) return(NA)
    a <- ranks(a[known])
    b <- ranks(b[known])
    if (length(unique(a)) < 2 || length(unique(b)) < 2) return(NA)
    cor(a, b)
}
mean_known <- function(values) if (all(is.na(values))) NA else mean(values, na.rm = TRUE)
mean_rows <- function(list_of) apply(do.call(rbind, list_of), 2, mean_known)

# --- who counts, and what each said -------------------------------------------------------------

people <- rows("participants.csv")
answers <- rows("answers.csv")
answers <- answers[answers$excluded == "0", ]
pairs <- rows("pairs.csv")
labels <- c(pairs$a[1], pairs$b[pairs$a == pairs$a[1]])
n <- length(labels)
pair_of <- function(a, b) match(paste(pmin(match(a, labels), match(b, labels)),
                                      pmax(match(a, labels), match(b, labels))),
                                paste(match(pairs$a, labels), match(pairs$b, labels)))
counted <- people$participant[people$counted == "1"]
is_sorting <- "group" %in% names(answers)

# Dissimilarities, one vector a pass through the pairs.
passes_of <- function(who, column) {
    own <- answers[answers$participant == who & answers$attention == "0", ]
    pair <- pair_of(own$a, own$b)
    pass <- ave(seq_along(pair), pair, FUN = seq_along)
    lapply(seq_len(if (length(pass)) max(pass) else 0), function(k) {
        values <- rep(NA_real_, nrow(pairs))
        values[pair[pass == k]] <- 100 - number(own[[column]])[pass == k]
        values
    })
}

# Two patterns in one group of a round are the more alike the more groups it had.
sorted_by <- function(who) {
    own <- answers[answers$participant == who, ]
    together <- all_groups <- rep(0, nrow(pairs))
    for (round in unique(own$round)) {
        part <- own[own$round == round, ]
        group <- part$group[match(labels, part$pattern)]
        a <- group[match(pairs$a, labels)]
        b <- group[match(pairs$b, labels)]
        known <- !is.na(a) & !is.na(b)
        groups <- length(unique(part$group))
        all_groups[known] <- all_groups[known] + groups
        together[known] <- together[known] + groups * (a == b)[known]
    }
    list(ifelse(all_groups > 0, 100 * (1 - together / all_groups), NA))
}

column <- if ("scaled" %in% names(answers)) "scaled" else "rating"
passes <- lapply(counted, function(who) if (is_sorting) sorted_by(who) else passes_of(who, column))
names(passes) <- counted
own <- lapply(passes[lengths(passes) > 0], mean_rows)
voices <- own
mean_of_people <- mean_rows(voices)
for (p in seq_len(nrow(pairs))) {
    check(sprintf("mean of %s and %s", pairs$a[p], pairs$b[p]), number(pairs$people[p]),
          mean_of_people[p])
}

with_others <- function(k, all_voices) spearman(all_voices[[k]], mean_rows(all_voices[-k]))
repeat_rho <- function(rated) {
    if (length(rated) < 2) return(NA)
    mean_known(combn(length(rated), 2, function(two) spearman(rated[[two[1]]], rated[[two[2]]])))
}
for (k in which(people$participant %in% names(own))) {
    who <- people$participant[k]
    check(paste0(who, ": rho of own repetitions"), number(people$repeat_rho[k]),
          repeat_rho(passes[[who]]))
    if (length(voices) > 1) {
        check(paste0(who, ": rho with the others"), number(people$rho_with_others[k]),
              with_others(match(who, names(own)), voices))
    }
}

# --- how alike people rate ----------------------------------------------------------------------

said <- rows("reliability.csv")
check_said <- function(statistic, here, tolerance = exact, field = "value") {
    k <- match(statistic, said$statistic)
    if (is.na(k)) return(invisible())
    what <- if (field == "value") statistic else paste0(statistic, ", ", field)
    check(what, number(said[[field]][k]), here, tolerance)
}

if (length(counted) == 1 && length(passes[[1]]) > 1) voices <- passes[[1]]
count <- length(voices)
if (count > 1) {
    half <- count %/% 2
    if (count <= 12) {
        halves <- combn(count, half, simplify = FALSE)
        if (count %% 2 == 0) halves <- Filter(function(part) 1 %in% part, halves)
        tolerance <- exact
    } else {
        halves <- lapply(1:1000, function(draw) sample(count, half))
        tolerance <- 0.01
    }
    of_halves <- mean_known(sapply(halves, function(part) {
        spearman(mean_rows(voices[part]), mean_rows(voices[-part]))
    }))
    stepped_up <- 2 * of_halves / (1 + of_halves)
    check_said("split_half", of_halves, tolerance)
    check_said("reliability", stepped_up, tolerance)
    check_said("ceiling_of_mean", if (stepped_up >= 0) sqrt(stepped_up) else NA, tolerance)
    check_said("one_with_others", mean_known(sapply(seq_len(count), with_others, voices)))
}

if (length(own) > 1) {
    table <- do.call(cbind, own)
    complete <- table[apply(is.finite(table), 1, all), , drop = FALSE]
    size <- nrow(complete)
    k <- ncol(complete)
    long <- data.frame(y = as.vector(complete), pair = factor(rep(seq_len(size), k)),
                       person = factor(rep(seq_len(k), each = size)))
    squares <- anova(lm(y ~ pair + person, long))[["Mean Sq"]]
    msr <- squares[1]
    msc <- squares[2]
    mse <- squares[3]
    single <- (msr - mse) / (msr + (k - 1) * mse + k * (msc - mse) / size)
    a <- k * single / (size * (1 - single))
    b <- 1 + a * (size - 1)
    df <- (size - 1) * (k - 1)
    v <- (a * msc + b * mse)^2 / ((a * msc)^2 / (k - 1) + (b * mse)^2 / df)
    low <- qf(0.975, size - 1, v)
    high <- qf(0.975, v, size - 1)
    others <- k * msc + (k * size - k - size) * mse
    check_said("icc_single", single)
    check_said("icc_single", size * (msr - low * mse) / (low * others + size * msr), exact, "low")
    check_said("icc_single", size * (high * msr - mse) / (others + size * high * msr), exact, "high")
    check_said("icc_mean", 1 - mse / msr)
    check_said("icc_mean", 1 - mse / msr * qf(0.975, size - 1, df), exact, "low")
    check_said("icc_mean", 1 - mse / msr / qf(0.975, df, size - 1), exact, "high")
    units <- Filter(function(unit) length(unit) > 1,
                    lapply(seq_len(nrow(table)), function(p) table[p, is.finite(table[p, ])]))
    values <- unlist(units)
    within <- sum(sapply(units, function(unit) sum(outer(unit, unit, "-")^2) / (length(unit) - 1)))
    overall <- 2 * (length(values) * sum(values^2) - sum(values)^2) / (length(values) - 1)
    check_said("alpha", 1 - within / overall)
}

# The share of drawn signs that do as well; NA where signs cannot change the number.
p_of_signs <- function(drawn, observed) {
    if (all(abs(drawn - observed) <= 1e-12 * abs(observed))) return(NA)
    (sum(drawn >= observed * (1 - 1e-12)) + 1) / (length(drawn) + 1)
}

# Within each person and pair: ratings one way round less those the other.
check_shift <- function(statistic, is_first) {
    part <- answers[answers$attention == "0" & answers$participant %in% counted & !is.na(is_first(answers)), ]
    if (nrow(part) == 0) return(invisible())
    first <- is_first(part)
    rating <- number(part$rating)
    cell <- paste(part$participant, part$a, part$b, sep = "\r")
    a <- tapply(rating[first], cell[first], mean)
    b <- tapply(rating[!first], cell[!first], mean)
    both <- intersect(names(a), names(b))
    if (length(both) == 0) return(invisible())
    points <- a[both] - b[both]
    of <- sub("^[^\r]*\r", "", both)
    spread <- function(signs) sum(tapply(signs * points, of, sum)^2 / tapply(points, of, length))
    observed <- spread(1)
    drawn <- replicate(1000, spread(sample(c(-1, 1), length(points), TRUE)))
    check_said(statistic, mean(points))
    check_said(statistic, p_of_signs(drawn, observed), 0.06, "p")
}

if (!is_sorting) {
    check_shift("side", function(part) part$side == "a")
    check_shift("felt_first", function(part) ifelse(part$felt_first == "NA", NA, part$felt_first == "a"))
    raw <- lapply(counted, passes_of, "rating")
    raw <- raw[lengths(raw) > 1]
    if (length(raw) > 0) {
        change <- sapply(raw, function(one) mean_known(one[[1]] - one[[length(one)]]))
        signs <- matrix(sample(c(-1, 1), 2000 * length(change), TRUE), 2000)
        drawn <- abs(signs %*% change / length(change))
        check_said("practice", mean(change))
        check_said("practice", p_of_signs(drawn, abs(mean(change))), 0.05, "p")
    }
}

# --- how well metrics agree ---------------------------------------------------------------------

places <- rows("maps.csv")
map_of <- function(of) {
    part <- places[places$map == of, ]
    part <- part[match(labels, part$pattern), c("x", "y", "z")]
    points <- matrix(number(as.matrix(part)), n)
    points[is.na(points)] <- 0
    points
}
square <- function(condensed) {
    full <- matrix(NA_real_, n, n)
    full[cbind(match(pairs$b, labels), match(pairs$a, labels))] <- condensed
    full[cbind(match(pairs$a, labels), match(pairs$b, labels))] <- condensed
    full
}
condensed <- function(full) full[cbind(match(pairs$a, labels), match(pairs$b, labels))]
distances <- function(points) condensed(as.matrix(dist(points)))
alienation <- function(d, e) sqrt(max(0, 1 - (sum(d * e) / sqrt(sum(d^2) * sum(e^2)))^2))
procrustes <- function(x, y) {
    x <- scale(x, scale = FALSE)
    y <- scale(y, scale = FALSE)
    sqrt(max(0, 1 - (sum(svd(t(x) %*% y)$d) / sqrt(sum(x^2) * sum(y^2)))^2))
}
# Kruskal's, with the monotone regression of d on delta; equal delta may be untied.
stress1 <- function(delta, d) {
    order_of <- order(ranks(delta), d)
    d <- d[order_of]
    sqrt(sum((d - isoreg(d)$yf)^2) / sum(d^2))
}

ratings <- number(pairs$people)
rated <- is.finite(ratings)
said_full <- square(ratings)
table <- rows("table.csv")

# The standard deviation of draws, and how far it may be from that of 2,000 others.
error_of_draws <- function(values) {
    values <- values[!is.na(values)]
    middle <- values - mean(values)
    error <- sqrt(mean(middle^2))
    spread <- sqrt((mean((middle / error)^4) - 1) / 4 * (1 / length(values) + 1 / 2000))
    c(error, 4 * spread * error + 1e-6)
}
# The standard error over people, each of whom was left out once.
jackknife <- function(values) sqrt((length(values) - 1) * mean((values - mean(values))^2))

draws <- lapply(seq_len(1000), function(draw) sample(n, n, TRUE))
without <- if (length(voices) < 2) list() else lapply(seq_along(voices),
                                                      function(k) mean_rows(voices[-k]))
resampled <- list()
for (k in seq_len(nrow(table))) {
    key <- table$metric[k]
    metric <- number(pairs[[key]])
    rho <- spearman(metric, ratings)
    check(paste0(key, ": rho"), number(table$rho[k]), rho)
    if (sum(rated) <= 3000) {
        check(paste0(key, ": tau-b"), number(table$tau_b[k]),
              cor(ranks(metric[rated]), ranks(ratings[rated]), method = "kendall"))
    }
    full <- square(metric)
    if (!is.na(rho)) {
        as_good <- sum(replicate(1000, {
            o <- sample(n)
            spearman(condensed(full[o, o]), ratings) >= rho - 1e-12
        }))
        check(paste0(key, ": p of rho"), number(table$p[k]), (as_good + 1) / 1001, 0.06)
        resampled[[key]] <- list(patterns = sapply(draws, function(o) {
            apart <- outer(o, o, "!=") & lower.tri(full)
            spearman(full[o, o][apart], said_full[o, o][apart])
        }), people = sapply(without, function(said) spearman(metric, said)))
        if (!is.na(number(table$rho_patterns_se[k]))) {
            found <- error_of_draws(resampled[[key]]$patterns)
            error <- number(table$rho_patterns_se[k])
            check(paste0(key, ": error over patterns"), error, found[1], found[2])
            check(paste0(key, ": rho_low"), number(table$rho_low[k]), max(rho - qnorm(0.975) * error, -1))
            check(paste0(key, ": rho_high"), number(table$rho_high[k]), min(rho + qnorm(0.975) * error, 1))
        }
        if (!is.na(number(table$rho_people_se[k]))) {
            check(paste0(key, ": error over people"), number(table$rho_people_se[k]),
                  jackknife(resampled[[key]]$people))
        }
    }
    if (key %in% places$map && "people" %in% places$map && !is.na(number(table$K[k]))) {
        d <- distances(map_of(key))
        e <- distances(map_of("people"))
        check(paste0(key, ": K"), number(table$K[k]), alienation(d, e))
        check(paste0(key, ": K of Procrustes"), number(table$K_procrustes[k]),
              procrustes(map_of(key), map_of("people")))
        check(paste0(key, ": stress-1"), number(table$stress1[k]), stress1(metric, d))
        whole <- square(d)
        as_good <- sum(replicate(1000, {
            o <- sample(n)
            alienation(condensed(whole[o, o]), e) <= alienation(d, e) + 1e-12
        }))
        check(paste0(key, ": p of K"), number(table$K_p[k]), (as_good + 1) / 1001, 0.06)
    }
}

# --- how much better PM is ----------------------------------------------------------------------

differences <- rows("differences.csv")
for (k in seq_len(nrow(differences))) {
    row <- differences[k, ]
    error <- number(row$se)
    if (is.na(error) || row$resampled == "both") next
    what <- paste0("pm - ", row$against, " over ", row$resampled)
    apart <- resampled$pm[[row$resampled]] - resampled[[row$against]][[row$resampled]]
    is_people <- row$resampled == "people"
    found <- if (is_people) c(jackknife(apart), exact) else error_of_draws(apart)
    check(paste0(what, ": error"), error, found[1], found[2])
    size <- abs(number(row$rho_difference)) / error
    check(paste0(what, ": p"), number(row$p),
          2 * if (is_people) pt(-size, length(voices) - 1) else pnorm(-size))
}

# --- what each goes by --------------------------------------------------------------------------

common <- rows("dimensions.csv")
weighed <- rows("weights.csv")
if (nrow(weighed) > 0) {
    axes <- grep("^dimension_", names(weighed), value = TRUE)
    x <- matrix(number(as.matrix(common[, axes, drop = FALSE])), nrow(common))
    inside <- match(common$pattern, labels)
    middle <- diag(nrow(x)) - 1 / nrow(x)
    check("common map: a column's sum of squares", 1, max(colSums(x^2)))
    for (k in seq_len(nrow(weighed))) {
        who <- weighed$participant[k]
        d <- square(own[[who]])[inside, inside]
        diag(d) <- 0
        b <- -0.5 * middle %*% d^2 %*% middle
        b <- b / sqrt(sum(b^2))
        w <- number(unlist(weighed[k, axes]))
        rest <- b - x %*% diag(w, length(w)) %*% t(x)
        check(paste0(who, ": share explained"), number(weighed$explained[k]), 1 - sum(rest^2))
        # No weight could be moved for the better: where it is 0, not upwards.
        slope <- -2 * diag(t(x) %*% rest %*% x)
        worst <- max(ifelse(w > 0, abs(slope), pmax(0, -slope)))
        check(paste0(who, ": slope at these weights"), 0, worst)
    }
}

cat(if (differing > 0) paste(differing, "differ\n") else "all agree\n")
quit(status = if (differing > 0) 1 else 0)
