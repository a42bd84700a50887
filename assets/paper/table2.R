# Table 2 of this folder again, from its CSV files alone, by another program than made it.
#
#     Rscript table2.R [FOLDER]
#
# Needs nothing but R. A line each: what it is, the table's number, the one found here. rho is Spearman's over
# the rated pairs; K the alienation of two maps by the publication's procedure (maps.csv). Ends with 1 if any
# differs.

arguments <- commandArgs(trailingOnly = TRUE)
script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE))
folder <- if (length(arguments) > 0) arguments[1] else if (length(script) > 0) dirname(script) else "."
differing <- 0

rows <- function(file) {
    read.csv(file.path(folder, file), check.names = FALSE, encoding = "UTF-8",
             colClasses = "character", na.strings = character(0))
}
number <- function(text) suppressWarnings(as.numeric(ifelse(text %in% c("", "NA"), NA, text)))
check <- function(what, of_table, here) {
    agrees <- (is.na(of_table) && is.na(here)) || isTRUE(abs(of_table - here) <= 1e-6)
    if (!agrees) differing <<- differing + 1
    cat(sprintf("%s %-50s %12.6g %12.6g\n", if (agrees) "ok     " else "DIFFERS", what, of_table, here))
}
# Of values that differ by more than a billionth of the largest; ties share the mean rank.
ranks <- function(values) rank(round(values / max(abs(values), 1e-300) * 1e9))
spearman <- function(a, b) {
    known <- is.finite(a) & is.finite(b)
    a <- ranks(a[known])
    b <- ranks(b[known])
    if (length(unique(a)) < 2 || length(unique(b)) < 2) return(NA)
    cor(a, b)
}
alienation <- function(x, y) {
    d <- as.vector(dist(x))
    e <- as.vector(dist(y))
    sqrt(max(0, 1 - sum(d * e)^2 / (sum(d^2) * sum(e^2))))
}

pairs <- rows("pairs.csv")
maps <- rows("maps.csv")
map_of <- function(set, name) {
    part <- maps[maps$set == set & maps$map == name, ]
    points <- sapply(c("x", "y", "z"), function(axis) number(part[[axis]]))
    if (nrow(part) == 0) NULL else points[, !is.na(points[1, ]), drop = FALSE]
}
table <- rows("table2.csv")
found <- list()
for (k in which(table$set != "average")) {
    row <- table[k, ]
    part <- pairs[pairs$set == row$set, ]
    rho <- spearman(number(part[[row$metric]]), number(part$people))
    own <- map_of(row$set, row$metric)
    people <- map_of(row$set, "people")
    alien <- if (is.null(own) || is.null(people)) NA else alienation(own, people)
    check(paste0(row$set, ": ", row$metric, ": rho"), number(row$rho), rho)
    check(paste0(row$set, ": ", row$metric, ": K"), number(row$K), alien)
    found[[row$metric]] <- rbind(found[[row$metric]], c(rho, alien))
}
for (k in which(table$set == "average")) {
    row <- table[k, ]
    of <- found[[row$metric]]
    # As the publication has it: an undefined rho is 0, its sign is dropped; a failed map is K = 1.
    check(paste0("average: ", row$metric, ": |rho|"), number(row$rho),
          mean(abs(ifelse(is.na(of[, 1]), 0, of[, 1]))))
    check(paste0("average: ", row$metric, ": K"), number(row$K), mean(ifelse(is.na(of[, 2]), 1, of[, 2])))
}

cat(if (differing > 0) paste(differing, "differ\n") else "all agree\n")
quit(status = if (differing > 0) 1 else 0)
