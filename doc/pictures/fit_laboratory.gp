# The picture that `kyvadlo fit --plot` draws of the laboratory of examples/fits.
system('kyvadlo fit examples/fits/laboratory.nml examples/fits/laboratory.csv --output fitted.txt --plot fitted.svg')
page = 'svg'
load 'fitted.gp'
